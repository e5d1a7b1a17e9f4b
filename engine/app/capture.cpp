#include "engine/app/capture.h"

#include <algorithm>
#include <filesystem>
#include <future>

#include "engine/app/recipe.h"
#include "engine/core/files.h"
#include "engine/core/frame_range.h"
#include "engine/core/interrupt.h"
#include "engine/core/text.h"
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
Result<CapturedFrame> write_picture(const Picture& picture, CapturedFrame frame, const std::string& hash, bool keep_alpha,
                                    Clock::time_point begun) {
  const PngText text{Recipe::png_keyword, hash};
  auto png = encode_png(picture.rgba, picture.width, picture.height, std::span(&text, 1), keep_alpha);
  if (!png) return pass_on(std::move(png));
  frame.sha256 = sha256(*png);
  if (auto ok = write_file(frame.file, *png); !ok) return pass_on(std::move(ok));
  frame.ms = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
  return frame;
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
      if (failures_.empty()) first_ = written.error();
      failures_.push_back(written.error().message);
    }
  }

  Result<void> verdict() const {
    if (failures_.empty()) return {};
    if (report.frames.empty()) return tl::unexpected<Error>(first_);
    return failure(ErrorKind::frames_failed, "{} of {} frames failed:\n  {}", failures_.size(),
                   failures_.size() + report.frames.size(), fmt::join(failures_, "\n  "));
  }

  CaptureReport report;

 private:
  std::vector<std::string> failures_;
  Error first_;
};

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

Result<void> check_picture_name(const std::string& output, const SceneOptions& scene) {
  const std::string ending = lower(std::filesystem::path(output).extension().string());
  for (const char* film : {".mp4", ".webm", ".gif"})
    if (ending == film)
      return failure(ErrorKind::usage, "-o {}: films cannot be written yet; write x_####.png, a picture a frame", output);
  std::error_code error;
  if (ending != ".png" && !std::filesystem::is_character_file(output, error))
    return failure(ErrorKind::usage, "-o {}: expected a name that ends in .png", output);
  if (scene.frames && scene.frames->size() > 1 && !has_frame_pattern(output))
    return failure(ErrorKind::usage, "-o {}: {} frames need a name with ####, such as frame_####.png", output,
                   scene.frames->size());
  return {};
}

Result<CaptureReport> capture(Device& device, const Stage& stage, const CaptureOptions& options) {
  const bool pattern = has_frame_pattern(options.output);
  const std::vector<int> frames = shard_of(selected_frames(stage, options.scene, !pattern), options.shard);
  if (frames.empty()) return CaptureReport{};
  if (auto ok = check_writable(frame_file_name(options.output, frames.front())); !ok) return pass_on(std::move(ok));
  Outcome outcome;
  auto maker = FrameMaker::create(device, stage, options.scene, options.look, outcome.report.problems);
  if (!maker) return pass_on(std::move(maker));

  const Recipe recipe(stage, options.scene, options.look);
  const bool keep_alpha = options.look.background.value_or(stage.scene.look.background).alpha == 0;
  Progress progress("rendering", frames.size(), options.progress);
  std::future<Result<CapturedFrame>> writing;
  const auto finish_writing = [&] {
    if (writing.valid()) outcome.add(writing.get());
  };
  for (const int frame : frames) {
    if (auto ok = check_interrupt(); !ok) {
      finish_writing();
      return pass_on(std::move(ok));
    }
    const Clock::time_point begun = Clock::now();
    CapturedFrame captured;
    captured.frame = frame;
    captured.file = frame_file_name(options.output, frame);
    const std::string hash = recipe.hash(frame);
    if (auto kept = options.resume ? kept_picture(captured, hash, options.look.size) : std::nullopt) {
      finish_writing();
      outcome.add(std::move(*kept));
      progress.advance();
      continue;
    }
    auto picture = maker->picture(frame);
    finish_writing();
    if (!picture) return pass_on(std::move(picture));
    writing = std::async(std::launch::async, [=, picture = std::move(*picture)] {
      return write_picture(picture, captured, hash, keep_alpha, begun);
    });
    progress.advance();
  }
  finish_writing();
  if (auto ok = outcome.verdict(); !ok) return pass_on(std::move(ok));
  return std::move(outcome.report);
}

}  // namespace sinew
