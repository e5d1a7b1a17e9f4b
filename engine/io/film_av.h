#pragma once
/// FFmpeg's objects as values that free themselves, and its failures as ours.

#include <filesystem>
#include <memory>
#include <string>

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavfilter/avfilter.h>
#include <libavformat/avformat.h>
#include <libavutil/dict.h>
}

#include "engine/core/result.h"

namespace sinew {

template <auto release>
struct AvRelease {
  template <class T>
  void operator()(T* object) const {
    release(&object);
  }
};

using AvFrame = std::unique_ptr<AVFrame, AvRelease<av_frame_free>>;
using AvPacket = std::unique_ptr<AVPacket, AvRelease<av_packet_free>>;
using AvEncoder = std::unique_ptr<AVCodecContext, AvRelease<avcodec_free_context>>;
using AvGraph = std::unique_ptr<AVFilterGraph, AvRelease<avfilter_graph_free>>;

/// From now on FFmpeg's log, which is one for the whole process, stays off the terminal: av_failure() tells the last
/// error in it.
void quiet_av_log();

/// What an FFmpeg error number means, such as "No space left on device".
std::string av_reason(int error);

/// cannot_write with FFmpeg's reason, and the last error that it logged since quiet_av_log().
tl::unexpected<Error> av_failure(const std::filesystem::path& file, int error);

/// "key=value:key=value" as FFmpeg's dictionary.
class AvOptions {
 public:
  explicit AvOptions(const char* text) { av_dict_parse_string(&dictionary_, text, "=", ":", 0); }
  ~AvOptions() { av_dict_free(&dictionary_); }
  AvOptions(const AvOptions&) = delete;
  AvOptions& operator=(const AvOptions&) = delete;

  AVDictionary** get() { return &dictionary_; }

 private:
  AVDictionary* dictionary_ = nullptr;
};

}  // namespace sinew
