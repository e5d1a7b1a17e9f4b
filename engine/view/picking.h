#pragma once
/// What of the characters lies under the pointer, how joints stand in the world, and limbs that are pulled there. No
/// interface here.

#include <optional>

#include "engine/app/stage.h"
#include "engine/render/screen.h"
#include "engine/rig/limb_reach.h"

namespace sinew {

/// From the eye through a point of the picture.
struct PointerRay {
  Vec3 eye{0.0};
  Vec3 way{0.0, 0.0, -1.0};  ///< unit length
};
/// `at`, `size`: pixels from the upper left corner, and the whole picture's.
PointerRay pointer_ray(const Viewpoint& viewpoint, const Vec2& at, const Vec2& size);
/// Where a ray meets the plane through a point; nothing where it runs along the plane or away from it.
std::optional<Vec3> meet_plane(const PointerRay& ray, const Vec3& point, const Vec3& normal);

/// A joint as it stands at a frame. `turn` is what a key of its own would have to say; where the scene's keys add to a
/// motion, what they say.
struct JointStand {
  TurnedJoint joint;
  Vec3 degrees{0.0};  ///< of the turn, as a key has them
};
JointStand joint_stand(const Stage& stage, std::size_t character, const CharacterState& state, int node,
                       const std::string& name, double frame);

/// Turns the limb's two joints at a frame so that its end comes as near to `target` (world) as it may. False where they
/// have no names to be called by. `character`: the scene's, to be changed.
bool reach_with(const Stage& stage, std::size_t number, const CharacterState& state, const Limb& limb,
                const Vec3& target, double frame, Character& character);

struct PickedJoint {
  std::size_t character = 0;
  int node = -1;
};
/// The joint that is drawn nearest to the point, at most `reach` pixels away; of some that are as near the foremost.
/// `states`: [characters] of the frame that is shown.
std::optional<PickedJoint> joint_near(const Stage& stage, const std::vector<CharacterState>& states, double frame,
                                      const Screen& screen, const Vec2& at, double reach);
/// The joint that the skin under the pointer follows most.
std::optional<PickedJoint> joint_of_skin(const Stage& stage, const std::vector<CharacterState>& states,
                                         const SceneOptions& options, const PointerRay& ray);

}  // namespace sinew
