#include "engine/app/bind_mesh.h"

#include <filesystem>

#include "engine/core/files.h"
#include "engine/core/fresh_output.h"
#include "engine/core/interrupt.h"
#include "engine/core/text.h"
#include "engine/fit/bound_model.h"
#include "engine/fit/transferred_weights.h"
#include "engine/fit/weight_run.h"
#include "engine/io/gltf_write.h"
#include "engine/io/mesh_read.h"

namespace sinew {
namespace {

void tell_report(const AutomaticWeightReport& report, std::vector<std::string>& problems) {
  if (!report.outside.empty())
    problems.push_back(fmt::format("{} joints lie outside of the mesh and move nothing: {}", report.outside.size(),
                                   fmt::join(report.outside, ", ")));
  if (!report.idle.empty())
    problems.push_back(fmt::format("{} joints got no vertex: {}", report.idle.size(), fmt::join(report.idle, ", ")));
  if (report.far > 0)
    problems.push_back(fmt::format("{} vertices are far from every bone, vertex {} of \"{}\" by {:.3g}", report.far,
                                   report.farthest, report.farthest_mesh, report.farthest_distance));
}

/// After edits there may be other numbers.
void count_weights(const Model& bound, AutomaticWeightReport& report) {
  const SkinnedShape shape = skinned_shapes(bound).front();
  report.vertices = shape.positions.size();
  report.joints = bound.skins[0].joints.size();
  report.max_influences = most_influences(shape.influences);
}

Result<void> check_stop(const BindMeshOptions& options) {
  if (options.weights.watch != nullptr)
    if (auto ok = options.weights.watch->check(); !ok) return ok;
  return check_interrupt();
}

}  // namespace

Result<AutomaticWeightReport> bind_mesh(const BindMeshOptions& options, std::vector<std::string>& problems) {
  if (lower(std::filesystem::path(options.output).extension().string()) != ".glb")
    return failure(ErrorKind::usage, "{}: expected a name that ends in .glb", options.output);
  const std::vector<std::string> inputs{options.mesh, options.skeleton, options.from};
  if (auto ok = check_fresh_output(options.output, inputs); !ok) return pass_on(std::move(ok));
  const auto mesh = read_mesh(options.mesh);
  if (!mesh) return tl::unexpected<Error>(mesh.error());
  problems.insert(problems.end(), mesh->problems.begin(), mesh->problems.end());
  if (auto ok = check_stop(options); !ok) return pass_on(std::move(ok));
  const auto skeleton = read_mesh(options.skeleton);
  if (!skeleton) return tl::unexpected<Error>(skeleton.error());
  if (options.skeleton != options.mesh)
    problems.insert(problems.end(), skeleton->problems.begin(), skeleton->problems.end());
  auto bound = bound_model(*mesh, *skeleton, {.keep_hung = true});
  if (!bound) return tl::unexpected<Error>(bound.error());
  AutomaticWeightReport report;
  if (options.from.empty()) {
    auto made = set_automatic_weights(options.weights, *bound);
    if (!made) return made;
    report = std::move(*made);
    tell_report(report, problems);
  } else if (auto ok = take_weights(options.from, *bound, problems); !ok) {
    return pass_on(std::move(ok));
  }
  if (auto ok = edit_weights(options.edits, *bound); !ok) return pass_on(std::move(ok));
  count_weights(*bound, report);
  const auto bytes = rig_glb(*bound);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  if (auto ok = check_stop(options); !ok) return pass_on(std::move(ok));
  if (auto ok = write_file(options.output, *bytes); !ok) return pass_on(std::move(ok));
  return report;
}

}  // namespace sinew
