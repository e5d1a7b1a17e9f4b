#include "engine/app/parity.h"

#include "engine/app/device_state.h"
#include "engine/core/interrupt.h"

namespace sinew {
namespace {

/// Sums up over frames and characters.
class Comparison {
 public:
  void add(const DeformedVertices& reference, std::span<const Vec4f> words) {
    for (std::size_t v = 0; v < reference.positions.size(); ++v) {
      const Vec4 position(words[v * layout::words_per_output]);
      const Vec3 normal(words[v * layout::words_per_output + 1]);
      box_.add(reference.positions[v]);
      add_position(glm::length(Vec3(position) - reference.positions[v]));
      raise(report_.max_height_error, std::abs(position.w - reference.heights[v]));
      add_normal(angle_degrees(normal, reference.normals[v]), nearly_singular(reference.blend[v]));
    }
  }

  ParityReport finish(std::size_t frames, std::size_t vertices, const ParityOptions& options) {
    report_.frames = frames;
    report_.vertices = vertices;
    report_.bbox_diagonal = box_.diagonal();
    if (count_ > 0) report_.rms_position_error = std::sqrt(squares_ / static_cast<double>(count_));
    report_.relative_error =
        report_.bbox_diagonal > 0.0 ? report_.max_position_error / report_.bbox_diagonal : report_.max_position_error;
    report_.pass = report_.relative_error <= options.tolerance &&
                   report_.max_normal_error_degrees <= options.normal_tolerance_degrees &&
                   report_.max_singular_normal_error_degrees <=
                       std::max(singular_normal_tolerance_degrees, options.normal_tolerance_degrees);
    return report_;
  }

 private:
  /// NaN counts as larger than any number, so that it can never pass.
  static void raise(double& largest, double value) {
    if (!(value <= largest)) largest = std::isnan(value) ? INFINITY : value;
  }

  void add_position(double error) {
    raise(report_.max_position_error, error);
    squares_ += error * error;
    ++count_;
  }

  void add_normal(double degrees, bool singular) {
    if (singular) ++report_.singular_normals;
    raise(singular ? report_.max_singular_normal_error_degrees : report_.max_normal_error_degrees, degrees);
  }

  ParityReport report_;
  Bounds box_;
  double squares_ = 0.0;
  std::size_t count_ = 0;
};

}  // namespace

Result<ParityReport> compare_with_reference(Device& device, const Stage& stage, const ParityOptions& options) {
  std::vector<GpuDeformer> deformers;
  for (const StagedCharacter& c : stage.characters) {
    const GpuDeformerOptions deform{
        .deformer = options.scene.deformer, .bulge = options.scene.bulge, .layout = options.layout};
    auto deformer = GpuDeformer::create(device, c.mesh, c.rest, c.muscles, deform);
    if (!deformer) return pass_on(std::move(deformer));
    deformers.push_back(std::move(*deformer));
  }
  const std::vector<int> frames = selected_frames(stage, options.scene, false);
  Progress progress("comparing", frames.size(), options.progress);
  Comparison comparison;
  for (const int frame : frames) {
    if (auto ok = check_interrupt(); !ok) return pass_on(std::move(ok));
    for (std::size_t i = 0; i < deformers.size(); ++i) {
      const CharacterState state = character_state(stage, i, frame);
      if (auto ok = load_state(stage.characters[i], state, deformers[i]); !ok) return pass_on(std::move(ok));
      if (auto ok = deformers[i].run(); !ok) return pass_on(std::move(ok));
      const auto words = deformers[i].read_back();
      if (!words) return tl::unexpected<Error>(words.error());
      comparison.add(deform_on_cpu(stage.characters[i], state, options.scene.deformer, options.scene.bulge), *words);
    }
    progress.advance();
  }
  return comparison.finish(frames.size(), stage.vertices(), options);
}

}  // namespace sinew
