#pragma once
/// Reads a film back with FFmpeg's decoders, its colours by BT.709's own formulas rather than by FFmpeg's converter.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}

#include "engine/model/picture.h"

namespace sinew::test {

struct FilmFrame {
  double seconds = 0.0;
  Picture picture;
};

struct ReadFilm {
  std::string problem;  ///< empty: the film was read to its end
  int width = 0, height = 0;
  std::string codec;
  AVRational fps = {0, 1};
  AVColorSpace matrix = AVCOL_SPC_UNSPECIFIED;
  AVColorRange range = AVCOL_RANGE_UNSPECIFIED;
  double duration = 0.0;  ///< seconds, as the file states it
  std::vector<FilmFrame> frames;
};

/// One pixel of brightness 16..235 and colour differences 16..240 (ITU-R BT.709, 3.4 to 3.6).
inline std::array<std::uint8_t, 3> rgb_of_bt709(int y, int cb, int cr) {
  const double e = (y - 16) / 219.0, b = (cb - 128) / 224.0, r = (cr - 128) / 224.0;
  const double red = e + 1.5748 * r, blue = e + 1.8556 * b;
  const double green = (e - 0.2126 * red - 0.0722 * blue) / 0.7152;
  const auto level = [](double v) { return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(v, 0.0, 1.0))); };
  return {level(red), level(green), level(blue)};
}

/// Empty where the frame's format is none of the three that films decode to.
inline Picture picture_of(const AVFrame& frame) {
  Picture picture{frame.width, frame.height, {}};
  for (int y = 0; y < frame.height; ++y)
    for (int x = 0; x < frame.width; ++x) {
      const auto at = [&](int plane, int column, int row) {
        return frame.data[plane][std::ptrdiff_t{row} * frame.linesize[plane] + column];
      };
      std::array<std::uint8_t, 3> rgb{};
      std::uint8_t alpha = 255;
      if (frame.format == AV_PIX_FMT_BGRA) {
        rgb = {at(0, 4 * x + 2, y), at(0, 4 * x + 1, y), at(0, 4 * x, y)};
        alpha = at(0, 4 * x + 3, y);
      } else if (frame.format == AV_PIX_FMT_YUV420P || frame.format == AV_PIX_FMT_YUVA420P) {
        rgb = rgb_of_bt709(at(0, x, y), at(1, x / 2, y / 2), at(2, x / 2, y / 2));
        if (frame.format == AV_PIX_FMT_YUVA420P) alpha = at(3, x, y);
      } else {
        return {};
      }
      picture.rgba.insert(picture.rgba.end(), {rgb[0], rgb[1], rgb[2], alpha});
    }
  return picture;
}

inline ReadFilm read_film(const std::string& file) {
  ReadFilm film;
  const auto failed = [&](const char* what) {
    film.problem = what;
    return film;
  };
  AVFormatContext* opened = nullptr;
  if (avformat_open_input(&opened, ("file:" + file).c_str(), nullptr, nullptr) < 0) return failed("does not open");
  const auto close = [](AVFormatContext* demuxer) { avformat_close_input(&demuxer); };
  const std::unique_ptr<AVFormatContext, decltype(close)> demuxer(opened, close);
  if (avformat_find_stream_info(opened, nullptr) < 0 || opened->nb_streams != 1) return failed("has not one stream");
  const AVStream& stream = *opened->streams[0];
  film.width = stream.codecpar->width;
  film.height = stream.codecpar->height;
  film.codec = avcodec_get_name(stream.codecpar->codec_id);
  film.fps = stream.avg_frame_rate;
  film.matrix = stream.codecpar->color_space;
  film.range = stream.codecpar->color_range;
  film.duration = double(opened->duration) / AV_TIME_BASE;

  // FFmpeg's own VP9 decoder leaves alpha out.
  const AVCodec* codec = film.codec == "vp9" ? avcodec_find_decoder_by_name("libvpx-vp9")
                                             : avcodec_find_decoder(stream.codecpar->codec_id);
  const auto free_decoder = [](AVCodecContext* decoder) { avcodec_free_context(&decoder); };
  const std::unique_ptr<AVCodecContext, decltype(free_decoder)> decoder(avcodec_alloc_context3(codec), free_decoder);
  if (!decoder || avcodec_parameters_to_context(decoder.get(), stream.codecpar) < 0 ||
      avcodec_open2(decoder.get(), codec, nullptr) < 0)
    return failed("has no decoder");

  const auto free_packet = [](AVPacket* packet) { av_packet_free(&packet); };
  const auto free_frame = [](AVFrame* frame) { av_frame_free(&frame); };
  const std::unique_ptr<AVPacket, decltype(free_packet)> packet(av_packet_alloc(), free_packet);
  const std::unique_ptr<AVFrame, decltype(free_frame)> frame(av_frame_alloc(), free_frame);
  for (bool more = true; more;) {
    more = av_read_frame(opened, packet.get()) >= 0;
    if (avcodec_send_packet(decoder.get(), more ? packet.get() : nullptr) < 0) return failed("does not decode");
    av_packet_unref(packet.get());
    while (avcodec_receive_frame(decoder.get(), frame.get()) >= 0)
      film.frames.push_back({double(frame->pts) * av_q2d(stream.time_base), picture_of(*frame)});
  }
  return film;
}

}  // namespace sinew::test
