#include "engine/app/capture.h"

#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>

#include <spdlog/spdlog.h>

#include "engine/app/recipe.h"
#include "engine/core/files.h"
#include "engine/core/frame_range.h"
#include "engine/core/interrupt.h"
#include "engine/core/ordered_work.h"
#include "engine/core/temporary_file.h"
#include "engine/core/text.h"
#include "engine/io/film.h"
#include "engine/io/png.h"

namespace sinew {
namespace {

using Clock = std::chrono::steady_clock;

/// That encode and write pictures: the disk is waited for on one while the other works.
constexpr std::size_t writing_threads = 2;

/// The picture that an earlier run left, where this run would make the same one.
std::optional<CapturedFrame> kept_picture(CapturedFrame frame, const std::string& hash, const PictureSize& size) {
  const auto bytes = read_file(frame.file);
  if (!bytes) return std::nullopt;
  const auto png = decode_png(*bytes);
  if (!png || png->width != size.width || png->height != size.height) return std::nullopt;
  const PngText wanted{Recipe::png_keyword, hash};
  if (std::find(png->texts.begin(), png->texts.end(), wanted) == png->texts.end()) return std::nullopt;
  frame.sha256 = sha256(*bytes);
  frame.skipped = true;
  return frame;
}

/// Encodes and writes one picture.
Result<CapturedFrame> write_picture(const Picture& picture, CapturedFrame frame, const std::string& hash,
                                    bool keep_alpha) {
  const PngText text{Recipe::png_keyword, hash};
  auto png = encode_png(picture.rgba, picture.width, picture.height, std::span(&text, 1), keep_alpha);
  if (!png) return pass_on(std::move(png));
  frame.sha256 = sha256(*png);
  if (auto ok = write_file(frame.file, *png); !ok) return pass_on(std::move(ok));
  return frame;
}

bool is_film(const std::string& output) {
  const std::string ending = lower(std::filesystem::path(output).extension().string());
  return ending == ".mp4" || ending == ".webm" || ending == ".gif";
}

bool keeps_alpha(const Stage& stage, const CaptureOptions& options) {
  return options.look.background.value_or(stage.scene.look.background).alpha == 0;
}

/// The shard's part: contiguous, and all parts together are all frames.
std::vector<int> shard_of(const std::vector<int>& frames, const Shard& shard) {
  const auto bound = [&](int i) {
    return frames.begin() + static_cast<std::ptrdiff_t>(frames.size() * static_cast<std::size_t>(i) /
                                                        static_cast<std::size_t>(shard.count));
  };
  return {bound(shard.index), bound(shard.index + 1)};
}

/// A disk that took none of so many pictures, one after another, will not take the next.
constexpr std::size_t most_failures_in_a_row = 20;

/// Gathers what became of each frame.
class Outcome {
 public:
  void add(Result<CapturedFrame> written) {
    in_a_row_ = written ? 0 : in_a_row_ + 1;
    if (written) {
      report.frames.push_back(std::move(*written));
    } else {
      if (!first_) first_ = written.error();
      failures_.push_back(written.error().message);
    }
  }

  Result<void> verdict() const {
    if (failures_.empty()) return {};
    if (report.frames.empty()) return tl::unexpected<Error>(*first_);
    constexpr std::size_t most_told = 10;
    const auto told = failures_.begin() + static_cast<std::ptrdiff_t>(std::min(failures_.size(), most_told));
    return failure(ErrorKind::frames_failed, "{} of {} frames failed{}:\n  {}{}", failures_.size(),
                   failures_.size() + report.frames.size(),
                   hopeless() ? ", the last of them one after another, and the rest was not tried" : "",
                   fmt::join(failures_.begin(), told, "\n  "), told == failures_.end() ? "" : "\n  ...");
  }

  bool hopeless() const { return in_a_row_ >= most_failures_in_a_row; }

  const std::optional<Error>& first_failure() const { return first_; }

  CaptureReport report;

 private:
  std::vector<std::string> failures_;
  std::size_t in_a_row_ = 0;
  std::optional<Error> first_;
};

/// Draws the picture of a number.
using Draw = std::function<Result<Picture>(int)>;

/// A picture on its way to a file; one that is kept from an earlier run has no pixels.
struct DrawnFrame {
  CapturedFrame frame;
  Picture picture;
  Clock::time_point begun;
};

using Writing = OrderedWork<DrawnFrame, Result<CapturedFrame>>;

/// Pictures that may wait between drawing and writing: enough that a slow one of either side does not hold up the
/// other, few enough that large ones do not fill the memory.
std::size_t waiting_pictures(const PictureSize& size) {
  constexpr std::size_t most = 6, most_bytes = std::size_t{512} << 20;
  return std::clamp<std::size_t>(most_bytes / (std::size_t{4} * size.width * size.height), 1, most);
}

/// What the process has taken of all cores, seconds.
double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// How long it took, from its making on.
class Stopwatch {
 public:
  void read(CaptureReport& report) const {
    report.seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
    report.cpu_seconds = cpu_seconds() - cpu_begun_;
  }

 private:
  Clock::time_point begun_ = Clock::now();
  double cpu_begun_ = cpu_seconds();
};

/// The write's outcome with the time since the frame was begun.
Result<CapturedFrame> timed(Result<CapturedFrame> written, Clock::time_point begun) {
  if (written) written->ms = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
  return written;
}

/// Between two frames: has a signal come, or has whoever watches had enough?
Result<void> check_stop(const CaptureOptions& options) {
  if (options.watch != nullptr)
    if (auto ok = options.watch->check(); !ok) return ok;
  return check_interrupt();
}

/// Rendering for hours what can be put nowhere helps nobody.
Result<void> check_folder(const std::string& output) {
  const std::filesystem::path named = std::filesystem::path(output).parent_path();
  const std::filesystem::path folder = named.empty() ? "." : named;
  // The working folder is still found when it was removed, but has no name any more.
  struct stat status {};
  if (::stat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_nlink > 0) return {};
  return failure(ErrorKind::cannot_write, "{}: the folder {} has gone since the start", output, folder.string());
}

Result<CaptureReport> capture_pictures(const Draw& draw, const std::string& figure, const Stage& stage,
                                       const CaptureOptions& options, const std::vector<int>& frames,
                                       Outcome& outcome) {
  const Recipe recipe(stage, options.scene, options.look, figure);
  const bool keep_alpha = keeps_alpha(stage, options);
  const std::size_t places = waiting_pictures(options.look.size);
  const Stopwatch stopwatch;
  Writing writing(std::min(places, writing_threads), places, [&](const DrawnFrame& drawn) -> Result<CapturedFrame> {
    if (drawn.frame.skipped) return drawn.frame;
    return timed(write_picture(drawn.picture, drawn.frame, recipe.hash(drawn.frame.frame), keep_alpha), drawn.begun);
  });
  Progress progress("rendering", frames.size(), options.progress);
  for (const int number : frames) {
    if (auto ok = check_stop(options); !ok) return pass_on(std::move(ok));
    if (auto ok = check_folder(options.output); !ok) return pass_on(std::move(ok));
    const Clock::time_point begun = Clock::now();
    CapturedFrame frame;
    frame.frame = number;
    frame.file = frame_file_name(options.output, number);
    auto kept = options.resume ? kept_picture(frame, recipe.hash(number), options.look.size) : std::nullopt;
    if (kept) {
      writing.add({std::move(*kept), {}, begun});
    } else {
      auto picture = draw(number);
      if (!picture) return pass_on(std::move(picture));
      writing.add({std::move(frame), std::move(*picture), begun});
    }
    while (auto written = writing.take_ready()) outcome.add(std::move(*written));
    if (outcome.hopeless()) break;
    progress.advance();
    if (options.watch != nullptr) options.watch->advance();
  }
  while (auto written = writing.take_next()) outcome.add(std::move(*written));
  stopwatch.read(outcome.report);
  if (auto ok = outcome.verdict(); !ok) return pass_on(std::move(ok));
  return std::move(outcome.report);
}

/// Puts the film under its name and takes its hash.
Result<void> complete(FilmWriter& film, const std::string& output, CaptureReport& report) {
  if (auto ok = film.finish(); !ok) return ok;
  const auto bytes = read_file(output, std::size_t{1} << 40);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  report.film = output;
  report.film_sha256 = sha256(*bytes);
  report.problems.insert(report.problems.end(), film.notes().begin(), film.notes().end());
  return {};
}

/// A film is whole or not there: the first failure ends it.
Result<CaptureReport> capture_film(const Draw& draw, const Stage& stage, const CaptureOptions& options,
                                   const std::vector<int>& frames, Outcome& outcome) {
  const PictureSize& size = options.look.size;
  auto film =
      FilmWriter::create(options.output, {size.width, size.height, stage.scene.fps, keeps_alpha(stage, options)});
  if (!film) return pass_on(std::move(film));
  const Stopwatch stopwatch;
  // Frames of a film depend on one another: one thread encodes them, and what it uses works on several by itself.
  Writing writing(1, waiting_pictures(size), [&](DrawnFrame drawn) -> Result<CapturedFrame> {
    drawn.frame.sha256 = sha256(drawn.picture.rgba);
    if (auto ok = film->add(drawn.picture); !ok) return pass_on(std::move(ok));
    return timed(std::move(drawn.frame), drawn.begun);
  });
  Progress progress("filming", frames.size(), options.progress);
  for (const int number : frames) {
    if (auto ok = check_stop(options); !ok) return pass_on(std::move(ok));
    if (auto ok = check_folder(options.output); !ok) return pass_on(std::move(ok));
    const Clock::time_point begun = Clock::now();
    CapturedFrame frame;
    frame.frame = number;
    auto picture = draw(number);
    if (!picture) return pass_on(std::move(picture));
    writing.add({std::move(frame), std::move(*picture), begun});
    while (auto written = writing.take_ready()) outcome.add(std::move(*written));
    if (outcome.first_failure()) return tl::unexpected<Error>(*outcome.first_failure());
    progress.advance();
    if (options.watch != nullptr) options.watch->advance();
  }
  while (auto written = writing.take_next()) outcome.add(std::move(*written));
  if (outcome.first_failure()) return tl::unexpected<Error>(*outcome.first_failure());
  if (auto ok = complete(*film, options.output, outcome.report); !ok) return pass_on(std::move(ok));
  stopwatch.read(outcome.report);
  return std::move(outcome.report);
}

}  // namespace

Result<Shard> parse_shard(std::string_view text) {
  const std::vector<std::string> parts = split(text, '/');
  constexpr long long most = 1'000'000;
  if (parts.size() == 2) {
    const auto index = parse_integer(parts[0]), count = parse_integer(parts[1]);
    if (index && count && *count >= 1 && *count <= most && *index >= 0 && *index < *count)
      return Shard{static_cast<int>(*index), static_cast<int>(*count)};
  }
  return failure(ErrorKind::usage, "--shard {}: expected I/N, such as 0/4 for the first of four parts", text);
}

Result<void> check_output(const CaptureOptions& options) {
  if (is_film(options.output)) {
    if (options.resume || options.shard.count > 1)
      return failure(ErrorKind::usage, "-o {}: a film is written whole; --resume and --shard go with pictures",
                     options.output);
    return check_film_name(options.output);
  }
  const std::string ending = lower(std::filesystem::path(options.output).extension().string());
  std::error_code error;
  if (ending != ".png" && !std::filesystem::is_character_file(options.output, error))
    return failure(ErrorKind::usage, "-o {}: expected a name that ends in .png, .mp4, .webm or .gif", options.output);
  if (options.figure.sheet || has_frame_pattern(options.output)) return {};
  const std::size_t frames = options.figure.turntable > 0 ? static_cast<std::size_t>(options.figure.turntable)
                             : options.scene.frames       ? options.scene.frames->size()
                                                          : 1;
  if (frames > 1)
    return failure(ErrorKind::usage, "-o {}: {} frames need a name with ####, such as frame_####.png", options.output,
                   frames);
  return {};
}

Result<CaptureReport> capture(Device& device, const Stage& stage, const CaptureOptions& options) {
  const bool film = is_film(options.output);
  const FigureLook figure = figure_look(options.figure, stage.scene.look);
  const bool whole_range = film || has_frame_pattern(options.output) || figure.sheet;
  const std::vector<int> frames = selected_frames(stage, options.scene, !whole_range);
  if (auto ok = check_writable(frame_file_name(options.output, frames.front())); !ok) return pass_on(std::move(ok));
  if (auto ok = check_not_an_input(stage, options.output); !ok) return pass_on(std::move(ok));
  remove_stale_temporaries(options.output);
  Outcome outcome;
  auto maker = FigureMaker::create(device, stage, options.scene, options.look, figure, outcome.report.problems);
  if (!maker) return pass_on(std::move(maker));
  const std::vector<int> numbers = shard_of(maker->numbers(frames), options.shard);
  if (numbers.empty())
    spdlog::info("shard {}/{} has no frame: there are only {}", options.shard.index, options.shard.count,
                 maker->numbers(frames).size());
  if (options.watch != nullptr) options.watch->begin(numbers.size());
  const Draw draw = [&](int number) { return maker->picture(number, frames); };
  return film ? capture_film(draw, stage, options, numbers, outcome)
              : capture_pictures(draw, maker->recipe(frames), stage, options, numbers, outcome);
}

}  // namespace sinew
