#pragma once
/// The studio that characters stand in: three lights that stand relative to the camera, the floor, and how the maps of
/// their shadows look at the scene. No Vulkan here.

#include "engine/render/viewpoint.h"

namespace sinew {

struct Studio {
  Vec3 key{0.0}, fill{0.0}, rim{0.0};  ///< directions towards the lights, world space, unit length
  Mat4 light_projection{1.0};          ///< world to the clip space of the key light's shadow map
  double shadow_width = 0.0;           ///< world length of that map's side
  Mat4 contact_projection{1.0};        ///< world to the clip space of the contact map: the scene from below the floor
  double contact_reach = 0.0;          ///< how far what stands on the floor darkens it; a share of that map's side
  Vec3 floor_centre{0.0};
  Vec2 floor_half_size{0.0};     ///< along x and z: what shadows can reach
  double fading_distance = 0.0;  ///< from the centre, at which shadows have faded
  Viewpoint viewpoint;           ///< the camera, its far plane behind the floor
};

/// `scene`: the box of all that is shown over the whole range. The floor lies at `floor_height`, shown or not. The key
/// light's map holds what the camera sees of scene and floor, and all of the scene that may throw a shadow there: what
/// is seen from near by has finer shadows.
Studio make_studio(const Viewpoint& viewpoint, double aspect, const Bounds& scene, double floor_height);

}  // namespace sinew
