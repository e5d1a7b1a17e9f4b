#include "engine/io/film_track.h"

#include <cassert>

extern "C" {
#include <libavutil/opt.h>
}

#include "engine/core/files.h"

namespace sinew {

Result<FilmTrack> FilmTrack::create(const FilmKind& kind, const std::filesystem::path& file,
                                    const FilmTrackOptions& options) {
  if (auto ok = check_writable(file); !ok) return pass_on(std::move(ok));
  std::error_code error_code;
  if (std::filesystem::is_character_file(file, error_code))
    return failure(ErrorKind::cannot_write, "{}: is a device; a film needs a file, in which its writer can go back",
                   file.string());
  auto hidden = TemporaryFile::create(file);
  if (!hidden) return pass_on(std::move(hidden));
  FilmTrack track(file, std::move(*hidden));
  if (const int error = track.open(kind, options); error < 0) return av_failure(file, error);
  return track;
}

int FilmTrack::open(const FilmKind& kind, const FilmTrackOptions& options) {
  packet_.reset(av_packet_alloc());
  AVFormatContext* muxer = nullptr;
  // "file:", so that a colon in the name is not taken for a protocol.
  const std::string url = "file:" + hidden_.path().string();
  if (const int error = avformat_alloc_output_context2(&muxer, nullptr, kind.muxer, url.c_str()); error < 0)
    return error;
  muxer_.reset(muxer);
  if (!packet_) return AVERROR(ENOMEM);
  if (const int error = open_encoder(kind, options); error < 0) return error;
  return open_muxer(kind, options);
}

int FilmTrack::open_encoder(const FilmKind& kind, const FilmTrackOptions& options) {
  encoder_.reset(avcodec_alloc_context3(avcodec_find_encoder_by_name(kind.encoder)));
  if (!encoder_) return AVERROR(ENOMEM);
  encoder_->width = options.width;
  encoder_->height = options.height;
  encoder_->sample_aspect_ratio = {1, 1};
  encoder_->pix_fmt = options.format;
  encoder_->time_base = options.tick;
  encoder_->framerate = options.rate;
  if (kind.colours == AVCOL_SPC_BT709) {
    encoder_->colorspace = kind.colours;
    encoder_->color_primaries = AVCOL_PRI_BT709;
    encoder_->color_trc = AVCOL_TRC_BT709;
    encoder_->color_range = AVCOL_RANGE_MPEG;
  }
  encoder_->flags |= AV_CODEC_FLAG_BITEXACT;
  if ((muxer_->oformat->flags & AVFMT_GLOBALHEADER) != 0) encoder_->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
  AvOptions encoder_options(kind.encoder_options);
  const int error = avcodec_open2(encoder_.get(), encoder_->codec, encoder_options.get());
  assert(error < 0 || av_dict_count(*encoder_options.get()) == 0);
  return error;
}

int FilmTrack::open_muxer(const FilmKind& kind, const FilmTrackOptions& options) {
  AVStream* stream = avformat_new_stream(muxer_.get(), nullptr);
  if (stream == nullptr) return AVERROR(ENOMEM);
  if (const int error = avcodec_parameters_from_context(stream->codecpar, encoder_.get()); error < 0) return error;
  stream->time_base = options.tick;
  stream->avg_frame_rate = options.rate;
  if (options.alpha) av_dict_set(&stream->metadata, "alpha_mode", "1", 0);
  // No dates, no versions, no random identifiers.
  muxer_->flags |= AVFMT_FLAG_BITEXACT;
  if (const int error = avio_open(&muxer_->pb, muxer_->url, AVIO_FLAG_WRITE); error < 0) return error;
  AvOptions muxer_options(kind.muxer_options);
  const int error = avformat_write_header(muxer_.get(), muxer_options.get());
  muxer_.get_deleter().owes_trailer = error >= 0;
  return error;
}

Result<void> FilmTrack::encode(AVFrame& frame) {
  // The encoder chooses what kind of frame it becomes, not what it was before.
  frame.pict_type = AV_PICTURE_TYPE_NONE;
  if (const int error = send(&frame); error < 0) return av_failure(file_, error);
  return {};
}

int FilmTrack::send(const AVFrame* frame) {
  if (const int error = avcodec_send_frame(encoder_.get(), frame); error < 0) return error;
  while (true) {
    const int received = avcodec_receive_packet(encoder_.get(), packet_.get());
    if (received == AVERROR(EAGAIN) || received == AVERROR_EOF) return 0;
    if (received < 0) return received;
    // Encoders leave it open, and the last one would last no time.
    if (packet_->duration == 0) packet_->duration = 1;
    packet_->stream_index = 0;
    av_packet_rescale_ts(packet_.get(), encoder_->time_base, muxer_->streams[0]->time_base);
    const int error = av_write_frame(muxer_.get(), packet_.get());
    av_packet_unref(packet_.get());
    if (error < 0) return error;
  }
}

Result<void> FilmTrack::finish(std::int64_t last_duration) {
  if (const int error = complete(last_duration); error < 0) return av_failure(file_, error);
  return hidden_.appear();
}

int FilmTrack::complete(std::int64_t last_duration) {
  if (const int error = send(nullptr); error < 0) return error;
  // Only .gif has it, and asks for it at the very end; the others go by the packet's duration.
  av_opt_set_int(muxer_->priv_data, "final_delay", last_duration, 0);
  muxer_.get_deleter().owes_trailer = false;
  if (const int error = av_write_trailer(muxer_.get()); error < 0) return error;
  // A late write error stands in `pb` alone.
  const int late = muxer_->pb->error;
  const int closed = avio_closep(&muxer_->pb);
  return late < 0 ? late : closed;
}

void CloseMuxer::operator()(AVFormatContext* muxer) const {
  if (owes_trailer) av_write_trailer(muxer);
  avio_closep(&muxer->pb);
  avformat_free_context(muxer);
}

}  // namespace sinew
