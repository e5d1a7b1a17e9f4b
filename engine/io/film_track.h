#pragma once
/// Encodes frames and puts them into a film's file.

#include <cstdint>

#include "engine/core/temporary_file.h"
#include "engine/io/film_av.h"
#include "engine/io/film_kind.h"

namespace sinew {

struct FilmTrackOptions {
  int width = 0, height = 0;
  AVPixelFormat format = AV_PIX_FMT_NONE;
  AVRational rate = {24, 1};  ///< frames a second
  AVRational tick = {1, 24};  ///< the unit of time
  bool alpha = false;
};

/// Closes a muxer and the file that it writes to.
struct CloseMuxer {
  /// Muxers let go of what they hold back only with the trailer, a dropped film's as well.
  bool owes_trailer = false;
  void operator()(AVFormatContext* muxer) const;
};

/// Every failure is cannot_write, and leaves a track that can only be dropped.
class FilmTrack {
 public:
  static Result<FilmTrack> create(const FilmKind& kind, const std::filesystem::path& file,
                                  const FilmTrackOptions& options);

  /// Its `pts` is in ticks.
  Result<void> encode(AVFrame& frame);
  /// The last frame lasts so many ticks. The file then stands under its name.
  Result<void> finish(std::int64_t last_duration);

 private:
  FilmTrack(const std::filesystem::path& file, TemporaryFile hidden) : file_(file), hidden_(std::move(hidden)) {}
  int open(const FilmKind& kind, const FilmTrackOptions& options);
  int open_encoder(const FilmKind& kind, const FilmTrackOptions& options);
  int open_muxer(const FilmKind& kind, const FilmTrackOptions& options);
  int send(const AVFrame* frame);
  int complete(std::int64_t last_duration);

  std::filesystem::path file_;
  TemporaryFile hidden_;
  AvEncoder encoder_;
  AvPacket packet_;
  std::unique_ptr<AVFormatContext, CloseMuxer> muxer_;
};

}  // namespace sinew
