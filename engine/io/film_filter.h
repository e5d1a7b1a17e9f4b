#pragma once
/// From RGB pictures to the frames that an encoder takes: brightness and colour differences, or a palette.

#include <cstdint>

#include "engine/io/film_av.h"
#include "engine/model/picture.h"

namespace sinew {

struct FilmFilterOptions {
  int width = 0, height = 0;  ///< of the frames; what a picture lacks is filled with its last column and row
  bool alpha = false;
  AVRational tick = {1, 1};  ///< the unit of time
  const char* filter = "";   ///< in FFmpeg's filter language
};

class FilmFilter {
 public:
  /// Fails with an FFmpeg error number.
  static tl::expected<FilmFilter, int> create(const FilmFilterOptions& options);

  /// Takes the picture of this time. 0, or an FFmpeg error number.
  int put(const Picture& picture, std::int64_t time);
  /// No more pictures will come. 0, or an FFmpeg error number.
  int end();
  /// The next frame: 0; AVERROR(EAGAIN) where the next picture is needed first, AVERROR_EOF after the last.
  int take(AVFrame* frame);

  AVPixelFormat format() const;

 private:
  FilmFilterOptions options_;
  AvGraph graph_;
  AVFilterContext* source_ = nullptr;  ///< inside the graph
  AVFilterContext* sink_ = nullptr;    ///< inside the graph
};

}  // namespace sinew
