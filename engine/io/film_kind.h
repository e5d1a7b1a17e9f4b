#pragma once
/// What each ending of a film's name stands for, and how it is made.

#include <filesystem>

extern "C" {
#include <libavutil/pixfmt.h>
#include <libavutil/rational.h>
}

#include "engine/core/result.h"

namespace sinew {

struct FilmKind {
  const char* ending;
  const char* muxer;
  const char* muxer_options;
  const char* encoder;
  const char* encoder_options;
  const char* filter;        ///< from RGB to what the encoder takes
  const char* alpha_filter;  ///< the same, alpha kept; null where the film has none
  AVColorSpace colours;      ///< its matrix, primaries and transfer go into the file
  bool even_sides;           ///< odd ones are padded
  AVRational tick;           ///< seconds, the unit of time; {0, 1}: whatever one picture lasts
  int shortest;              ///< ticks that a picture stays at least: of those that come sooner, some are left out
};

/// The kind of the file's ending, in any case of letters. Fails as check_film_name() does.
Result<const FilmKind*> film_kind(const std::filesystem::path& file);

/// Fails as cannot_write, with what to install, where this machine's FFmpeg lacks the kind's encoder or muxer.
Result<void> check_encoder(const FilmKind& kind, const std::filesystem::path& file);

/// Frames a second as the ratio that was meant: 24 is 24/1, 12.5 is 25/2, and 23.976, 23.98, 29.97, 59.94 are NTSC's
/// 24000/1001, 30000/1001, 60000/1001.
AVRational frame_rate(double fps);

}  // namespace sinew
