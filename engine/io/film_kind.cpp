#include "engine/io/film_kind.h"

#include <array>
#include <cmath>

#include "engine/core/text.h"
#include "engine/io/film.h"
#include "engine/io/film_av.h"

namespace sinew {
namespace {

// A palette for every picture: one for the whole film would have to see all pictures first. Measured on lit renders, no
// dithering is as good (62 dB) and ordered dithering is worse and larger; on smooth colours, such as normals, only
// error diffusion hides the bands.
constexpr const char* palette_filter =
    "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=sierra2_4a";

// The number of threads is part of what an encoder writes: fixed, so that the bytes do not depend on the machine.
constexpr std::array<FilmKind, 3> kinds = {{
    {
        .ending = ".mp4",
        .muxer = "mp4",
        .muxer_options = "movflags=+faststart",
        .encoder = "libx264",
        .encoder_options = "preset=veryfast:crf=18:threads=2:x264-params=cpu-independent=1",
        .filter = "scale=out_color_matrix=bt709:out_range=tv:flags=bilinear+accurate_rnd+bitexact,format=yuv420p",
        .alpha_filter = nullptr,
        .colours = AVCOL_SPC_BT709,
        .even_sides = true,
        .tick = {0, 1},
        .shortest = 1,
    },
    {
        .ending = ".webm",
        .muxer = "webm",
        .muxer_options = "",
        .encoder = "libvpx-vp9",
        .encoder_options = "deadline=realtime:cpu-used=6:row-mt=1:tile-columns=1:crf=30:b=0:auto-alt-ref=0:threads=2",
        .filter = "scale=out_color_matrix=bt709:out_range=tv:flags=bilinear+accurate_rnd+bitexact,format=yuv420p",
        .alpha_filter =
            "scale=out_color_matrix=bt709:out_range=tv:flags=bilinear+accurate_rnd+bitexact,format=yuva420p",
        .colours = AVCOL_SPC_BT709,
        .even_sides = false,
        .tick = {0, 1},
        .shortest = 1,
    },
    {
        .ending = ".gif",
        .muxer = "gif",
        .muxer_options = "loop=0",
        .encoder = "gif",
        .encoder_options = "threads=1",
        .filter = palette_filter,
        .alpha_filter = palette_filter,
        .colours = AVCOL_SPC_UNSPECIFIED,
        .even_sides = false,
        .tick = {1, 100},
        .shortest = 2,  // browsers take a delay below this for a tenth of a second
    },
}};

}  // namespace

Result<const FilmKind*> film_kind(const std::filesystem::path& file) {
  const std::string ending = lower(file.extension().string());
  for (const FilmKind& kind : kinds) {
    if (ending != kind.ending) continue;
    if (auto ok = check_encoder(kind, file); !ok) return pass_on(std::move(ok));
    return &kind;
  }
  return failure(ErrorKind::usage, "{}: expected a film's name that ends in .mp4, .webm or .gif", file.string());
}

Result<void> check_encoder(const FilmKind& kind, const std::filesystem::path& file) {
  if (avcodec_find_encoder_by_name(kind.encoder) != nullptr && av_guess_format(kind.muxer, nullptr, nullptr) != nullptr)
    return {};
  return failure(ErrorKind::cannot_write,
                 "{}: FFmpeg's libraries here cannot write {}: they lack the encoder {}; install a build that has it "
                 "(Debian: libavcodec59 or libavcodec-extra59), or name a film of another ending",
                 file.string(), kind.ending, kind.encoder);
}

AVRational frame_rate(double fps) {
  // People write NTSC's rates with two or three decimals: 23.98 is 0.004 away.
  constexpr double written_precision = 0.004;
  const int nominal = static_cast<int>(std::lround(fps * 1.001));
  const bool ntsc = nominal > 0 && nominal % 6 == 0 && std::abs(fps - nominal / 1.001) < written_precision;
  return ntsc ? AVRational{nominal * 1000, 1001} : av_d2q(fps, 1'000'000);
}

Result<void> check_film_name(const std::filesystem::path& file) {
  auto kind = film_kind(file);
  if (!kind) return pass_on(std::move(kind));
  return {};
}

}  // namespace sinew
