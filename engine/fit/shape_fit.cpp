#include "engine/fit/shape_fit.h"

#include <algorithm>
#include <chrono>

#include "engine/fit/weight_run.h"

namespace sinew {
namespace {

constexpr std::size_t most_worst = 10;

std::string mesh_name(const Model& model, const ShapePart& part) {
  const std::string& name = model.meshes[part.mesh].name;
  return name.empty() ? fmt::format("meshes/{}", part.mesh) : name;
}

void add_reasons(const Model& model, const SkinnedShape& shape, const SkinFitJob& job, const SkinFitReport& fit,
                 FitReport& report) {
  const BonePoses& bones = job.bones;
  if (bones.poses < job.influences)
    report.reasons.push_back(
        fmt::format("{} pose{} leave{} much open: weights of {} influences that fit them may be wrong in others",
                    bones.poses, bones.poses == 1 ? "" : "s", bones.poses == 1 ? "s" : "", job.influences));
  const std::vector<int>& joints = model.skins[shape.skin].joints;
  Bounds bounds;
  for (const Vec3& p : shape.positions) bounds.add(p);
  for (const auto& [bone, like] : bones_moved_alike(bones, bounds))
    report.reasons.push_back(fmt::format("\"{}\" moves like \"{}\" in all poses: their weights cannot be told apart",
                                         model.nodes[joints[bone]].name, model.nodes[joints[like]].name));
  if (fit.undetermined > 0)
    report.reasons.push_back(
        fmt::format("the weights of {} vertices are not determined by {} poses: some of their bones move them alike",
                    fit.undetermined, bones.poses));
}

}  // namespace

double squared_distance(const Vec3& a, const Vec3& b) { return glm::dot(a - b, a - b); }

void FitReport::measure(const Bounds& rest) {
  const Vec3 size = rest.high - rest.low;
  diagonal = rest.diagonal();
  height = std::max({size.x, size.y, size.z});
}

void report_errors(const Model& model, const SkinnedShape& shape, std::span<const Vec3> fitted,
                   std::span<const Vec3> wanted, std::span<const std::uint32_t> shell, FitReport& report) {
  const std::size_t vertices = shape.positions.size(), poses = wanted.size() / vertices;
  std::vector<ShellResidual> shells(vertices == 0 ? 0 : *std::max_element(shell.begin(), shell.end()) + 1);
  double total = report.rmse * report.rmse * static_cast<double>(report.vertices * poses);
  for (std::size_t v = 0; v < vertices; ++v) {
    double squared = 0.0;
    for (std::size_t i = v * poses; i < (v + 1) * poses; ++i) {
      const double one = squared_distance(fitted[i], wanted[i]);
      squared += one;
      report.max_error = std::max(report.max_error, std::sqrt(one));
    }
    total += squared;
    const std::string mesh = mesh_name(model, shape.part_of(v));
    ShellResidual& piece = shells[shell[v]];
    if (piece.vertices++ == 0) piece.mesh = mesh;
    piece.rmse += squared;
    report.worst.push_back({report.vertices + v, mesh, std::sqrt(squared / static_cast<double>(poses))});
  }
  std::sort(report.worst.begin(), report.worst.end(), [](const WorstVertex& a, const WorstVertex& b) {
    return a.rmse != b.rmse ? a.rmse > b.rmse : a.vertex < b.vertex;
  });
  report.worst.resize(std::min(report.worst.size(), most_worst));
  for (ShellResidual& piece : shells) piece.rmse = std::sqrt(piece.rmse / static_cast<double>(piece.vertices * poses));
  report.shells.insert(report.shells.end(), shells.begin(), shells.end());
  std::stable_sort(report.shells.begin(), report.shells.end(),
                   [](const ShellResidual& a, const ShellResidual& b) { return a.rmse > b.rmse; });
  report.vertices += vertices;
  report.rmse = std::sqrt(total / static_cast<double>(report.vertices * poses));
}

Result<Influences> fit_shape(const Model& model, const SkinnedShape& shape, const BonePoses& bones,
                             std::span<const Vec3> wanted, const FitOptions& options, FitReport& report) {
  SkinFitJob job{shape.positions, wanted, shape.triangles, bones, options.method, options.influences};
  if (auto ok = job.validate(); !ok) return bad_input("{}, skins/{}: {}", model.file, shape.skin, ok.error().message);
  Progress progress("fitting weights", job.steps(), options.progress);
  job.advance = [&progress] { progress.advance(); };
  SkinFitReport fit;
  const auto start = std::chrono::steady_clock::now();
  auto influences = job.run(fit);
  if (!influences) return influences;
  report.milliseconds += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  report_errors(model, shape, skinned_places(shape.positions, *influences, bones), wanted, fit.shell, report);
  add_reasons(model, shape, job, fit, report);
  report.max_influences = std::max(report.max_influences, most_influences(*influences));
  report.noise = std::max(report.noise, fit.noise);
  report.negative += fit.negative;
  report.undetermined += fit.undetermined;
  return influences;
}

}  // namespace sinew
