#pragma once
/// A head's regions as data: what moves which vertices how far. engine/definitions.md 15.
///
/// Laid out for a compute pass: a vertex has one FaceVertex and a short run of FaceDeltas, as it has morph deltas;
/// everything else is a handful of numbers a head and a frame.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

/// The numbers that a face is moved by. Lengths in drawing units (crown to chin 3.5), `right` and `up` as the viewer
/// sees them, `turn` counter-clockwise for the viewer; left and right in names are the character's own.
enum class FaceChannel : std::uint8_t {
  brow_left_right,
  brow_left_up,
  brow_left_turn,  ///< degrees
  brow_right_right,
  brow_right_up,
  brow_right_turn,
  upper_lid_left,  ///< 0 at rest, 1 shut, negative wider
  upper_lid_right,
  lower_lid_left,
  lower_lid_right,
  eye_left_yaw,  ///< degrees, to the viewer's right
  eye_left_pitch,
  eye_right_yaw,
  eye_right_pitch,
  upper_lip_up,
  lower_lip_up,
  corner_left_right,
  corner_left_up,
  corner_right_right,
  corner_right_up,
  jaw_drop,
  cheek_left_up,
  cheek_right_up,
  nose_wrinkle,
  lip_pucker,  ///< 0 to 1
  lip_press,   ///< 0 to 1
  lip_seal,    ///< 0 to 1: how closed the lips stay when the jaw drops
};
constexpr std::size_t face_channels = 27;
using FaceChannels = std::array<double, face_channels>;

inline double& channel(FaceChannels& channels, FaceChannel c) { return channels[static_cast<std::size_t>(c)]; }
inline double channel(const FaceChannels& channels, FaceChannel c) { return channels[static_cast<std::size_t>(c)]; }

/// A channel's name in files: its region as scenes name it and, where the region has several numbers, which.
struct FaceChannelName {
  const char* region;
  const char* number;  ///< "" where the region has one
};
const std::array<FaceChannelName, face_channels>& face_channel_names();
/// Both in one word: "browLeft.up", "jaw".
std::string channel_word(FaceChannel channel);

/// What the deltas are multiplied by: all that is linear. The sides' come twice, left first.
enum class FaceSignal : std::uint8_t {
  brow_out,
  brow_in,
  brow_up,
  brow_down,
  brow_turn_inner,  ///< tangent of the turn about the outer end
  brow_turn_outer,  ///< about the inner end
  corner_out,
  corner_in,
  corner_up,
  corner_down,
  cheek_up,
  lid_close,  ///< the last three turn vertices; their deltas hold normals alone
  lid_wide,
  lid_lower,
};
constexpr std::size_t face_side_signals = 14;
enum class FaceMiddleSignal : std::uint8_t {
  upper_lip_up,
  lower_lip_up,
  lower_lip_down,
  pucker,
  press,
  nose,
  jaw  ///< normals alone
};
constexpr std::size_t face_signals = 2 * face_side_signals + 7;

constexpr std::size_t signal_index(FaceSignal signal, std::size_t side) {
  return side * face_side_signals + static_cast<std::size_t>(signal);
}
constexpr std::size_t signal_index(FaceMiddleSignal signal) {
  return 2 * face_side_signals + static_cast<std::size_t>(signal);
}

/// One signal's share in one vertex, at signal 1.
struct FaceDelta {
  std::uint32_t signal;
  Vec3 position;
  Vec3 normal;
};

/// How a vertex takes part in what turns.
struct FaceVertex {
  double jaw = 0.0;             ///< share of the jaw's turn
  double jaw_sealed = 0.0;      ///< the same with sealed lips
  int eye = -1;                 ///< 0 left, 1 right: whose lid or ball it is; -1 neither
  bool ball = false;            ///< turns with the gaze
  double close_upper = 0.0;     ///< radians about the eyeball's centre, about x, at upper lid 1
  double close_lower = 0.0;     ///< at lower lid 1
  double least_distance = 0.0;  ///< from the eyeball's centre, which the vertex never goes below; 0: may be anywhere
};

/// How far a region may go, under the names of the thesis (Yen 1990, 5.3); for the left as the viewer sees it, the
/// right is its mirror image. Drawing units, degrees and shares, at scale 1.
struct FaceLimits {
  double eyebrow_up_vertical, eyebrow_down_vertical;     ///< EYEBROW_L_U_VERT_LIMIT, EYEBROW_L_D_VERT_LIMIT
  double eyebrow_out_horizontal, eyebrow_in_horizontal;  ///< EYEBROW_L_L_HORT_LIMIT, EYEBROW_L_R_HORT_LIMIT
  double eyebrow_rotate_range;                           ///< EYEBROW_ROTATE_RANGE
  double eyelid_upper_wide;                              ///< EYELID_LU_U_VERT_LIMIT, as a share of closing
  double eyelid_lower_up;                                ///< EYELID_LD_U_VERT_LIMIT, likewise
  double eyeball_yaw, eyeball_up, eyeball_down;          ///< within the rest outline of the lids
  double lip_up, lip_down;                               ///< LIP_U_VERT_LIMIT, LIP_D_VERT_LIMIT from LIPS_MATCH_LEVEL
  double corner_out, corner_in, corner_up, corner_down;  ///< MOUTH_CORNER_L_L_HORT_LIMIT ... _D_VERT_LIMIT
  double chin_drop;                                      ///< CHIN_D_LIMIT
  double cheek_up, nose_wrinkle;                         ///< helpers, not of the thesis
};

/// Regions of a face that has them all.
struct FaceRig {
  std::vector<FaceVertex> vertices;
  std::vector<std::uint32_t> first{0};  ///< [vertices + 1] where each vertex's run starts in `deltas`
  std::vector<FaceDelta> deltas;

  Vec3 hinge{0.0};          ///< of the jaw
  double chin_reach = 1.0;  ///< depth of the chin before the hinge
  double chin_fall = 0.0;   ///< height of the hinge above the chin
  double eye_radius = 0.0;
  std::array<Vec3, 2> eye_centres{};
  FaceLimits limits{};                                         ///< of this head: already scaled
  double eye_scale = 1.0, mouth_scale = 1.0, jaw_scale = 1.0;  ///< this head's sizes over the adult's
  std::vector<Vec2> brow_outline;                              ///< of the left brow at rest
  double brow_inner = 0.0, brow_outer = 0.0;  ///< distances of its ends from the middle: pivots of its turn

  /// Whether a vertex takes part in anything.
  bool moves(std::size_t v) const {
    const FaceVertex& vertex = vertices[v];
    return vertex.eye >= 0 || vertex.jaw != 0.0 || vertex.jaw_sealed != 0.0 || first[v] != first[v + 1];
  }
};

/// Adds a vertex behind the others.
void append_vertex(const FaceVertex& vertex, const std::vector<FaceDelta>& deltas, FaceRig& rig);

/// The mean of vertices, by weights: for what sits on the skin, so that it takes no part in lids and eyes.
struct FaceBlend {
  FaceVertex vertex;
  std::vector<FaceDelta> deltas;
};
FaceBlend blend_vertices(const FaceRig& rig, std::span<const std::uint32_t> vertices, std::span<const double> weights);

/// The face without its vertices: what limits and amounts go by.
FaceRig face_sizes(const FaceRig& rig);

/// The same face on other vertices: each takes part as the one of `rig` that it names. [vertices wanted]
FaceRig picked_face(const FaceRig& rig, std::span<const std::uint32_t> vertices);

/// Where a face's drawing units lie in a mesh's bind pose: p = origin + unit * (axes * d).
struct FacePlace {
  Mat3 axes{1.0};    ///< a rotation: the head's left, its up, its front
  Vec3 origin{0.0};  ///< under the chin, in the middle of the skull
  double unit = 1.0;
};

/// Heights of the lines that a head is drawn by (Loomis 1956), drawing units; not a number where nobody knows.
struct FaceGuides {
  double crown = NAN, hair_line = NAN, brow = NAN, eye_line = NAN, nose_base = NAN, lip_contact = NAN, chin = NAN;
};
/// A guide line's landmark.
struct FaceGuideName {
  const char* name;   ///< as landmarks are named
  const char* words;  ///< for people
  double FaceGuides::*height;
};
std::span<const FaceGuideName> face_guide_names();

/// The face of a character. Whoever knows a mesh's regions gives it: a drawn head its own, a transfer another's.
struct CharacterFace {
  FaceRig rig;  ///< in the order of the mesh's vertices; those beside the face take part in nothing
  FacePlace place;
  FaceGuides guides;
};

}  // namespace sinew
