#include "engine/app/measure.h"

namespace sinew {
namespace {

/// A character posed and swollen, and the limb on it.
struct Measured {
  const StagedCharacter& character;
  int joint, child;
  std::vector<std::uint32_t> triangles;
  std::vector<Vec3> positions;
  std::vector<Mat4> global;

  PosedSurface surface() const { return {*character.model, character.mesh, triangles, positions, global}; }
};

Result<Measured> prepare(const Stage& stage, const std::string& name) {
  std::optional<Error> unknown;
  for (std::size_t i = 0; i < stage.characters.size(); ++i) {
    const StagedCharacter& character = stage.characters[i];
    const auto joint = find_joint(*character.model, character.humanoid, name);
    if (!joint) {
      unknown = joint.error();
      continue;
    }
    const int child = joint_after(*character.model, character.humanoid, *joint);
    if (child < 0)
      return bad_input("{}: joint \"{}\": there is no joint after it, so that there is no limb to measure",
                       character.model->file, name);
    CharacterState state = character_state(stage, i, stage.range.first);
    const Mat4 placement = character_placement(stage, i, stage.range.first);
    for (Mat4& global : state.global) global = placement * global;
    return Measured{character,
                    *joint,
                    child,
                    welded_triangles(character.mesh, character.rest),
                    deform_on_cpu(character, state, Deformer::ssd, BulgeMode::on).positions,
                    std::move(state.global)};
  }
  return tl::unexpected<Error>(unknown.value_or(Error{ErrorKind::bad_input, "the scene has no character"}));
}

/// The same failure, with its file.
template <class T>
Result<T> in_file(const Measured& measured, Result<T>&& result) {
  if (result) return std::move(result);
  return bad_input("{}: {}", measured.character.model->file, result.error().message);
}

}  // namespace

Result<Girth> measure_girth(const Stage& stage, const std::string& joint, double at) {
  auto measured = prepare(stage, joint);
  if (!measured) return pass_on(std::move(measured));
  return in_file(*measured, limb_girth(measured->surface(), measured->joint, measured->child, at));
}

Result<SegmentVolume> measure_volume(const Stage& stage, const std::string& joint) {
  auto measured = prepare(stage, joint);
  if (!measured) return pass_on(std::move(measured));
  return in_file(*measured, segment_volume(measured->surface(), measured->joint, measured->child));
}

}  // namespace sinew
