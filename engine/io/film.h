#pragma once
/// Films: .mp4, .webm and .gif, one picture at a time.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/model/picture.h"

namespace sinew {

/// Films larger than this, either way, are refused.
constexpr int largest_film_side = 16384;

struct FilmOptions {
  int width = 0, height = 0;  ///< of every picture
  double fps = 24.0;          ///< 0.01 to 1000; 23.976, 29.97 and the like mean 24000/1001, 30000/1001
  bool keep_alpha = false;    ///< .webm and .gif (on or off at one half); otherwise alpha is dropped, not blended
};

/// What a file name asks for. Fails as usage on an ending other than .mp4, .webm and .gif, and as cannot_write where
/// this machine's FFmpeg lacks the encoder. Opens no file.
Result<void> check_film_name(const std::filesystem::path& file);

/// Writes a film to a hidden temporary beside its final name, and renames it when it is complete. The same pictures
/// give the same bytes. FFmpeg's log of the whole process is kept off the terminal from the first film on.
class FilmWriter {
 public:
  /// Fails as check_film_name does, as bad_input on options out of range, and as cannot_write where the file cannot be
  /// created or the encoder does not take films of this size.
  static Result<FilmWriter> create(const std::filesystem::path& file, const FilmOptions& options);

  FilmWriter(FilmWriter&&) noexcept;
  FilmWriter& operator=(FilmWriter&&) noexcept;
  /// Drops a film that is not finished: what stood under its name before stays, and no temporary is left.
  ~FilmWriter();

  /// The next picture. After a failure nothing more is taken, and finish() fails with the same reason.
  Result<void> add(const Picture& picture);

  /// Completes the film and puts it under its name. Fails as bad_input where it has no picture. To be called once,
  /// last.
  Result<void> finish();

  /// What the film could not do as asked, for the log; complete once the film is finished.
  const std::vector<std::string>& notes() const;

 private:
  class Film;
  explicit FilmWriter(std::unique_ptr<Film> film);

  std::unique_ptr<Film> film_;
};

}  // namespace sinew
