#include "engine/io/film_filter.h"

#include <algorithm>
#include <cstring>

extern "C" {
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
#include <libavutil/mem.h>
}

namespace sinew {
namespace {

struct Ends {
  AVFilterInOut* source = nullptr;
  AVFilterInOut* sink = nullptr;
  ~Ends() {
    avfilter_inout_free(&source);
    avfilter_inout_free(&sink);
  }
};

AVFilterInOut* end_of_graph(const char* name, AVFilterContext* filter) {
  AVFilterInOut* end = avfilter_inout_alloc();
  if (end != nullptr) *end = {av_strdup(name), filter, 0, nullptr};
  return end;
}

/// FFmpeg's "RGB0" says that the fourth byte means nothing: conversions make it opaque.
AVPixelFormat picture_format(bool alpha) { return alpha ? AV_PIX_FMT_RGBA : AV_PIX_FMT_RGB0; }

void copy_padded(const Picture& picture, AVFrame& frame) {
  const std::size_t row_bytes = std::size_t{4} * picture.width;
  for (int y = 0; y < frame.height; ++y) {
    std::uint8_t* row = frame.data[0] + std::ptrdiff_t{y} * frame.linesize[0];
    std::memcpy(row, picture.rgba.data() + std::min(y, picture.height - 1) * row_bytes, row_bytes);
    for (int x = picture.width; x < frame.width; ++x) std::memcpy(row + std::size_t{4} * x, row + row_bytes - 4, 4);
  }
}

}  // namespace

tl::expected<FilmFilter, int> FilmFilter::create(const FilmFilterOptions& options) {
  FilmFilter made;
  made.options_ = options;
  made.graph_.reset(avfilter_graph_alloc());
  if (!made.graph_) return tl::unexpected(AVERROR(ENOMEM));
  made.graph_->nb_threads = 1;

  const std::string in = fmt::format("video_size={}x{}:pix_fmt={}:time_base={}/{}", options.width, options.height,
                                     int(picture_format(options.alpha)), options.tick.num, options.tick.den);
  int error = avfilter_graph_create_filter(&made.source_, avfilter_get_by_name("buffer"), "in", in.c_str(), nullptr,
                                           made.graph_.get());
  if (error >= 0)
    error = avfilter_graph_create_filter(&made.sink_, avfilter_get_by_name("buffersink"), "out", nullptr, nullptr,
                                         made.graph_.get());
  if (error < 0) return tl::unexpected(error);

  // Named from inside the filter's text: its open input is our source's output.
  Ends ends{end_of_graph("in", made.source_), end_of_graph("out", made.sink_)};
  error = avfilter_graph_parse_ptr(made.graph_.get(), options.filter, &ends.sink, &ends.source, nullptr);
  if (error >= 0) error = avfilter_graph_config(made.graph_.get(), nullptr);
  if (error < 0) return tl::unexpected(error);
  return made;
}

int FilmFilter::put(const Picture& picture, std::int64_t time) {
  const AvFrame frame(av_frame_alloc());
  if (!frame) return AVERROR(ENOMEM);
  frame->width = options_.width;
  frame->height = options_.height;
  frame->format = picture_format(options_.alpha);
  frame->sample_aspect_ratio = {1, 1};
  frame->pts = time;
  if (const int error = av_frame_get_buffer(frame.get(), 0); error < 0) return error;
  copy_padded(picture, *frame);
  return av_buffersrc_add_frame(source_, frame.get());
}

int FilmFilter::end() { return av_buffersrc_add_frame(source_, nullptr); }

int FilmFilter::take(AVFrame* frame) { return av_buffersink_get_frame(sink_, frame); }

AVPixelFormat FilmFilter::format() const { return static_cast<AVPixelFormat>(av_buffersink_get_format(sink_)); }

}  // namespace sinew
