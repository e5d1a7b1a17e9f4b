#include "engine/app/capture.h"

#include <filesystem>
#include <future>

#include <nlohmann/json.hpp>

#include "engine/app/version.h"
#include "engine/core/files.h"
#include "engine/core/frame_range.h"
#include "engine/core/interrupt.h"
#include "engine/core/text.h"
#include "engine/io/png.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

using Clock = std::chrono::steady_clock;

/// What a picture depends on, but for its frame: scene, options and program version; no output path, device or date.
std::string recipe(const Stage& stage, const CaptureOptions& options) {
  const LookOptions& look = options.look;
  nlohmann::ordered_json json;
  json["scene"] = stage.scene_hash;
  json["deformer"] = deformer_name(options.scene.deformer);
  json["bulge"] = bulge_name(options.scene.bulge);
  json["size"] = {look.size.width, look.size.height};
  json["samples"] = look.samples;
  if (look.view) json["view"] = view_names()[static_cast<std::size_t>(*look.view)];
  if (look.orbit) json["orbit"] = *look.orbit;
  if (look.shading) json["shading"] = shading_names()[static_cast<std::size_t>(*look.shading)];
  if (look.background) json["background"] = colour_text(*look.background);
  json["version"] = version();
  return json.dump();
}

std::string recipe_hash(const std::string& recipe, int frame) { return sha256(fmt::format("{}#{}", recipe, frame)); }

/// Encodes and writes one picture.
Result<CapturedFrame> write_picture(const Picture& picture, CapturedFrame frame, const std::string& hash, bool keep_alpha,
                                    Clock::time_point begun) {
  const PngText text{"sinew-recipe", hash};
  auto png = encode_png(picture.rgba, picture.width, picture.height, std::span(&text, 1), keep_alpha);
  if (!png) return pass_on(std::move(png));
  frame.sha256 = sha256(*png);
  if (auto ok = write_file(frame.file, *png); !ok) return pass_on(std::move(ok));
  frame.ms = std::chrono::duration<double, std::milli>(Clock::now() - begun).count();
  return frame;
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
  const std::vector<int> frames = selected_frames(stage, options.scene, !pattern);
  if (auto ok = check_writable(frame_file_name(options.output, frames.front())); !ok) return pass_on(std::move(ok));
  Outcome outcome;
  auto maker = FrameMaker::create(device, stage, options.scene, options.look, outcome.report.problems);
  if (!maker) return pass_on(std::move(maker));

  const std::string base = recipe(stage, options);
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
    auto picture = maker->picture(frame);
    finish_writing();
    if (!picture) return pass_on(std::move(picture));
    const CapturedFrame captured{frame, frame_file_name(options.output, frame), {}, 0.0};
    writing = std::async(std::launch::async, [=, hash = recipe_hash(base, frame), picture = std::move(*picture)] {
      return write_picture(picture, captured, hash, keep_alpha, begun);
    });
    progress.advance();
  }
  finish_writing();
  if (auto ok = outcome.verdict(); !ok) return pass_on(std::move(ok));
  return std::move(outcome.report);
}

}  // namespace sinew
