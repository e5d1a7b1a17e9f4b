#include "engine/io/film.h"

#include <algorithm>
#include <optional>

#include "engine/io/film_filter.h"
#include "engine/io/film_track.h"

namespace sinew {

namespace fs = std::filesystem;

class FilmWriter::Film {
 public:
  static Result<std::unique_ptr<Film>> create(const fs::path& file, const FilmOptions& options);

  Result<void> add(const Picture& picture);
  Result<void> finish();
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  Film(const fs::path& file, const FilmOptions& options, const FilmKind& kind)
      : file_(file), options_(options), kind_(kind), rate_(frame_rate(options.fps)) {}

  Result<void> open();
  Result<void> take(const Picture& picture);
  Result<void> encode_filtered();
  AVRational tick() const { return kind_.tick.num == 0 ? av_inv_q(rate_) : kind_.tick; }
  /// When the picture of this number begins. From the number and not from the one before: errors do not add up.
  std::int64_t time_of(std::int64_t picture) const { return av_rescale_q(picture, av_inv_q(rate_), tick()); }

  fs::path file_;
  FilmOptions options_;
  const FilmKind& kind_;
  AVRational rate_;
  std::optional<FilmFilter> filter_;
  std::optional<FilmTrack> track_;
  AvFrame filtered_{av_frame_alloc()};
  std::int64_t pictures_ = 0, left_out_ = 0;
  std::int64_t last_time_ = 0;
  std::optional<Error> failed_;
  std::vector<std::string> notes_;
};

Result<std::unique_ptr<FilmWriter::Film>> FilmWriter::Film::create(const fs::path& file, const FilmOptions& options) {
  auto kind = film_kind(file);
  if (!kind) return pass_on(std::move(kind));
  if (options.width < 1 || options.height < 1 || options.width > largest_film_side ||
      options.height > largest_film_side)
    return bad_input("{}: a film of {} x {} pixels cannot be written: each side is 1 to {}", file.string(),
                     options.width, options.height, largest_film_side);
  if (!(options.fps >= 0.01 && options.fps <= 1000.0))
    return bad_input("{}: a film of {} frames a second cannot be written: 0.01 to 1000 can", file.string(),
                     options.fps);
  std::unique_ptr<Film> film(new Film(file, options, **kind));
  if (auto ok = film->open(); !ok) return pass_on(std::move(ok));
  return film;
}

Result<void> FilmWriter::Film::open() {
  quiet_av_log();
  int width = options_.width, height = options_.height;
  if (kind_.even_sides && (width % 2 != 0 || height % 2 != 0)) {
    width += width % 2;
    height += height % 2;
    notes_.push_back(
        fmt::format("{}: {} x {} became {} x {}: {} needs even sides, so the last column or row is repeated",
                    file_.string(), options_.width, options_.height, width, height, kind_.ending));
  }
  const bool alpha = options_.keep_alpha && kind_.alpha_filter != nullptr;
  if (options_.keep_alpha && !alpha)
    notes_.push_back(
        fmt::format("{}: transparency is lost: {} has none; .webm keeps it", file_.string(), kind_.ending));

  auto filter = FilmFilter::create({.width = width,
                                    .height = height,
                                    .alpha = alpha,
                                    .tick = tick(),
                                    .filter = alpha ? kind_.alpha_filter : kind_.filter});
  if (!filter) return av_failure(file_, filter.error());
  filter_.emplace(std::move(*filter));
  auto track = FilmTrack::create(
      kind_, file_,
      {.width = width, .height = height, .format = filter_->format(), .rate = rate_, .tick = tick(), .alpha = alpha});
  if (!track) return pass_on(std::move(track));
  track_.emplace(std::move(*track));
  return {};
}

Result<void> FilmWriter::Film::add(const Picture& picture) {
  if (failed_) return tl::unexpected<Error>(*failed_);
  auto taken = take(picture);
  if (!taken) failed_ = taken.error();
  return taken;
}

Result<void> FilmWriter::Film::take(const Picture& picture) {
  if (picture.width != options_.width || picture.height != options_.height ||
      picture.rgba.size() != std::size_t{4} * picture.width * picture.height)
    return bad_input("{}: picture {} is {} x {} of {} bytes; the film is {} x {}", file_.string(), pictures_,
                     picture.width, picture.height, picture.rgba.size(), options_.width, options_.height);
  const std::int64_t number = pictures_++, time = time_of(number);
  if (number > 0 && time < last_time_ + kind_.shortest) {
    ++left_out_;
    return {};
  }
  last_time_ = time;
  if (const int error = filter_->put(picture, time); error < 0) return av_failure(file_, error);
  return encode_filtered();
}

Result<void> FilmWriter::Film::encode_filtered() {
  while (true) {
    const int taken = filter_->take(filtered_.get());
    if (taken == AVERROR(EAGAIN) || taken == AVERROR_EOF) return {};
    if (taken < 0) return av_failure(file_, taken);
    auto encoded = track_->encode(*filtered_);
    av_frame_unref(filtered_.get());
    if (!encoded) return encoded;
  }
}

Result<void> FilmWriter::Film::finish() {
  if (failed_) return tl::unexpected<Error>(*failed_);
  if (pictures_ == 0) return bad_input("{}: a film needs at least one picture", file_.string());
  if (left_out_ > 0)
    notes_.push_back(fmt::format("{}: {} of {} pictures are left out: {} shows at most {} a second", file_.string(),
                                 left_out_, pictures_, kind_.ending, kind_.tick.den / kind_.shortest));
  if (const int error = filter_->end(); error < 0) return av_failure(file_, error);
  if (auto ok = encode_filtered(); !ok) return ok;
  return track_->finish(std::max<std::int64_t>(time_of(pictures_) - last_time_, kind_.shortest));
}

FilmWriter::FilmWriter(std::unique_ptr<Film> film) : film_(std::move(film)) {}
FilmWriter::FilmWriter(FilmWriter&&) noexcept = default;
FilmWriter& FilmWriter::operator=(FilmWriter&&) noexcept = default;
FilmWriter::~FilmWriter() = default;

Result<FilmWriter> FilmWriter::create(const fs::path& file, const FilmOptions& options) {
  auto film = Film::create(file, options);
  if (!film) return pass_on(std::move(film));
  return FilmWriter(std::move(*film));
}

Result<void> FilmWriter::add(const Picture& picture) { return film_->add(picture); }
Result<void> FilmWriter::finish() { return film_->finish(); }
const std::vector<std::string>& FilmWriter::notes() const { return film_->notes(); }

}  // namespace sinew
