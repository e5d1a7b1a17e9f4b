#include <utility>

#include "engine/model/scene_words.h"
#include "engine/view/viewer_session.h"

namespace sinew {

void ViewerSession::start_binding() {
  const SkinPanel& panel = state_.skin;
  BindMeshOptions options;
  options.mesh = panel.mesh;
  options.skeleton = panel.skeleton;
  options.output = panel.output;
  options.weights.influences = options.edits.influences = static_cast<std::size_t>(panel.influences);
  options.weights.resolution = panel.resolution;
  options.edits.prune = options.weights.prune;
  bound_ = {panel.mesh, panel.output};
  const std::string name = std::filesystem::path(panel.mesh).filename().string();
  const bool started = binding_.start("binding " + name, [options](TaskWatch& watch) -> Result<BoundMesh> {
    BindMeshOptions watched = options;
    watched.weights.watch = &watch;
    BoundMesh bound;
    auto report = bind_mesh(watched, bound.problems);
    if (!report) return pass_on(std::move(report));
    bound.report = std::move(*report);
    return bound;
  });
  if (started) say("binding " + name + " ...");
}

void ViewerSession::follow_binding() {
  if (std::exchange(state_.skin.bind, false)) start_binding();
  const auto done = binding_.take();
  state_.skin.binds = binding_.running();
  if (!done) return;
  if (!*done) {
    if (done->error().kind == ErrorKind::interrupted) return say(binding_.what() + ": stopped, nothing is written");
    return say(done->error());
  }
  const BoundMesh& bound = **done;
  const auto& [mesh, output] = bound_;
  document().forget_spare(output);
  const std::string told(bound.problems.empty()
                             ? fmt::format("{}: {} vertices follow {} joints", output, bound.report.vertices,
                                           bound.report.joints - bound.report.outside.size() - bound.report.idle.size())
                             : bound.problems.front());
  // Where the bare mesh alone is open there is nothing to keep: the new file is opened in its place.
  if (state_.file == mesh && !has_unsaved() && !opening_.running()) {
    open_beside(output);
    opened_told_ = told;
    return;
  }
  Scene scene = document().scene();
  bool used = false;
  for (Character& character : scene.characters)
    if (character.model == mesh) {
      character.model = output;
      used = true;
    }
  if (!used) return say(output + " is written; its mesh is not in this scene any more");
  take_edit(ViewState::Edit{std::move(scene), told, ""});
}

}  // namespace sinew
