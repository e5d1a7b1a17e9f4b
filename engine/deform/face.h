#pragma once
/// A face moved by its regions: held at their limits, resolved into signals, carried out on the vertices.
/// engine/definitions.md 15; Yen 1990, 4.2 and 5.3.

#include <span>
#include <vector>

#include "engine/core/result.h"
#include "engine/model/face.h"

namespace sinew {

/// A channel that was asked to go further than it may.
struct HeldChannel {
  FaceChannel channel;
  double asked, held;
};

struct HeldFace {
  FaceChannels channels;          ///< within all limits
  std::vector<HeldChannel> held;  ///< what was changed, in the channels' order
};

/// Each region moved back to its limit where it is beyond. A brow is judged by its highest and lowest points; an upper
/// lid shuts on the lower lid; the lower lip does not rise above the upper.
HeldFace hold_at_limits(const FaceRig& rig, const FaceChannels& channels);

/// What a frame's channels mean to all vertices alike.
struct FaceState {
  std::array<double, face_signals> signals{};
  double jaw_angle = 0.0;    ///< radians about x at share 1
  double jaw_forward = 0.0;  ///< added to z at share 1: part of the chin's swing back is given back
  double seal = 0.0;
  std::array<double, 2> upper_lid{}, lower_lid{};
  std::array<Vec2, 2> gaze{};  ///< yaw, pitch, radians
  double eye_share = 1.0;      ///< size of the eyeballs: below 1 where they draw back behind linear lids
};
/// `channels` within limits.
FaceState face_state(const FaceRig& rig, const FaceChannels& channels);

/// A direction at a vertex, turned as jaw, lid or gaze turn the vertex; the face's axes.
Vec3 turned_with_face(const FaceRig& rig, const FaceState& state, std::size_t vertex, const Vec3& direction);

/// v' = lids(deltas(jaw(v))), pushed out of the eyeball. Normals turn with the vertices and have deltas of their own.
struct FaceJob {
  const FaceRig& rig;
  const FaceState& state;
  std::span<const Vec3> rest;          ///< [vertices] drawing units
  std::span<const Vec3> rest_normals;  ///< [vertices] or empty
  std::span<Vec3> posed;               ///< [vertices] out
  std::span<Vec3> normals;             ///< [vertices] out, unit length; or empty

  /// Says which span is short.
  Result<void> validate() const;
  void run() const;
};

}  // namespace sinew
