#include "engine/app/capture.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <future>

#include "engine/app/recipe.h"
#include "engine/core/files.h"
#include "engine/core/frame_range.h"
#include "engine/core/interrupt.h"
#include "engine/core/text.h"
#include "engine/io/film.h"
#include "engine/io/png.h"

namespace sinew {
namespace {

using Clock = std::chrono::steady_clock;

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

/// Gathers what became of each frame.
class Outcome {
 public:
  void add(Result<CapturedFrame> written) {
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
    return failure(ErrorKind::frames_failed, "{} of {} frames failed:\n  {}", failures_.size(),
                   failures_.size() + report.frames.size(), fmt::join(failures_, "\n  "));
  }

  const std::optional<Error>& first_failure() const { return first_; }

  CaptureReport report;

 private:
  std::vector<std::string> failures_;
  std::optional<Error> first_;
};

/// What is done with a finished picture, on a thread of its own, one picture after another.
using Write = std::function<Result<CapturedFrame>(const Picture&, CapturedFrame)>;

/// Draws the picture of a number.
using Draw = std::function<Result<Picture>(int)>;

/// Draws frames while the one before is written.
class Sequence {
 public:
  Sequence(Draw draw, Outcome& outcome, Write write)
      : draw_(std::move(draw)), outcome_(outcome), write_(std::move(write)) {}
  ~Sequence() { finish(); }

  Result<void> add(CapturedFrame frame) {
    const Clock::time_point begun = Clock::now();
    auto picture = draw_(frame.frame);
    finish();
    if (!picture) return pass_on(std::move(picture));
    writing_ = std::async(std::launch::async, [this, frame = std::move(frame), picture = std::move(*picture), begun] {
      auto written = write_(picture, frame);
      if (written) written->ms = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
      return written;
    });
    return {};
  }

  /// Waits for the last picture.
  void finish() {
    if (writing_.valid()) outcome_.add(writing_.get());
  }

 private:
  Draw draw_;
  Outcome& outcome_;
  Write write_;
  std::future<Result<CapturedFrame>> writing_;
};

Result<CaptureReport> capture_pictures(const Draw& draw, const std::string& figure, const Stage& stage,
                                       const CaptureOptions& options, const std::vector<int>& frames,
                                       Outcome& outcome) {
  const Recipe recipe(stage, options.scene, options.look, figure);
  const bool keep_alpha = keeps_alpha(stage, options);
  Sequence sequence(draw, outcome, [&](const Picture& picture, const CapturedFrame& frame) {
    return write_picture(picture, frame, recipe.hash(frame.frame), keep_alpha);
  });
  Progress progress("rendering", frames.size(), options.progress);
  for (const int number : frames) {
    if (auto ok = check_interrupt(); !ok) return pass_on(std::move(ok));
    CapturedFrame frame;
    frame.frame = number;
    frame.file = frame_file_name(options.output, number);
    auto kept = options.resume ? kept_picture(frame, recipe.hash(number), options.look.size) : std::nullopt;
    if (kept) {
      sequence.finish();
      outcome.add(std::move(*kept));
    } else if (auto ok = sequence.add(frame); !ok) {
      return pass_on(std::move(ok));
    }
    progress.advance();
  }
  sequence.finish();
  if (auto ok = outcome.verdict(); !ok) return pass_on(std::move(ok));
  return std::move(outcome.report);
}

/// A film is whole or not there: the first failure ends it.
Result<CaptureReport> capture_film(const Draw& draw, const Stage& stage, const CaptureOptions& options,
                                   const std::vector<int>& frames, Outcome& outcome) {
  const PictureSize& size = options.look.size;
  auto film =
      FilmWriter::create(options.output, {size.width, size.height, stage.scene.fps, keeps_alpha(stage, options)});
  if (!film) return pass_on(std::move(film));
  Sequence sequence(draw, outcome, [&](const Picture& picture, CapturedFrame frame) -> Result<CapturedFrame> {
    frame.sha256 = sha256(picture.rgba);
    if (auto ok = film->add(picture); !ok) return pass_on(std::move(ok));
    return frame;
  });
  Progress progress("filming", frames.size(), options.progress);
  for (const int number : frames) {
    if (auto ok = check_interrupt(); !ok) return pass_on(std::move(ok));
    CapturedFrame frame;
    frame.frame = number;
    if (auto ok = sequence.add(frame); !ok) return pass_on(std::move(ok));
    if (outcome.first_failure()) return tl::unexpected<Error>(*outcome.first_failure());
    progress.advance();
  }
  sequence.finish();
  if (auto ok = film->finish(); !ok) return pass_on(std::move(ok));
  const auto bytes = read_file(options.output, std::size_t{1} << 40);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  outcome.report.film = options.output;
  outcome.report.film_sha256 = sha256(*bytes);
  outcome.report.problems.insert(outcome.report.problems.end(), film->notes().begin(), film->notes().end());
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
  const bool whole_range = film || has_frame_pattern(options.output) || options.figure.sheet;
  const std::vector<int> frames = selected_frames(stage, options.scene, !whole_range);
  if (auto ok = check_writable(frame_file_name(options.output, frames.front())); !ok) return pass_on(std::move(ok));
  if (auto ok = check_not_an_input(stage, options.output); !ok) return pass_on(std::move(ok));
  Outcome outcome;
  auto maker = FigureMaker::create(device, stage, options.scene, options.look, options.figure, outcome.report.problems);
  if (!maker) return pass_on(std::move(maker));
  const std::vector<int> numbers = shard_of(maker->numbers(frames), options.shard);
  const Draw draw = [&](int number) { return maker->picture(number, frames); };
  return film ? capture_film(draw, stage, options, numbers, outcome)
              : capture_pictures(draw, maker->recipe(frames), stage, options, numbers, outcome);
}

}  // namespace sinew
