#pragma once
/// The coarse mesh of half a head, from which subdivision makes the skin: 640-odd points, each with a name of its own,
/// in rings round eye, mouth and ear and in grids between them. Its numbers of points and quads never change: measures
/// only place them. The half is the character's left, x >= 0; points of the mid line have x = 0 exactly.

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <vector>

#include "engine/face/head_loft.h"

namespace sinew {

enum class HeadPart : std::uint8_t { eye, nose, nostril, mouth, bag, cheek, chin, forehead, side, cap, ear, neck };

/// The name of a point. Rings and places count as follows.
/// eye: ring 0 (inside the ball), 1, 2 (the lid's edge), 3, 4 (its fold), 5, 6 (the socket's rim); place 0 the inner
///   corner, 1-7 the upper lid, 8 the outer corner, 9-15 the lower lid.
/// nose: ring 0 the mid line, 1 beside it, 2 the wing, 3 the wing's crease; place 0 (brows) to 7 (base).
/// nostril: ring 0, 1 (inside); place 0-3.
/// mouth: ring 0, 1 (inside), 2 (where the lips meet), 3 (fullest), 4 (their border), 5, 6; place 0 (top middle)
///   to 5 (corner) to 10 (bottom middle).
/// bag: the mouth's back wall; ring the column from the middle, place the row.
/// cheek: ring the column 1-3 from the nose, place the row 1-10. chin: ring the column from the cheek, place 1, 2.
/// forehead: ring 1 above the brows, 2 at the hair; place 0 (middle) to 6.
/// side: ring the column: 0 before the cheek, 1 before the ear, 2 under it, 3 behind it, 4-7 the back; place the row.
/// cap: the crown; ring the column from the middle, place 1-5 from front to back.
/// ear: ring 1 its back, 2 the rim, 3-6 into the shell, 7 its floor; place 0-7 front, 8 lobe, 9-16 back, 17 top.
/// neck: ring 0 under the jaw to 5 the base; place 0 (front) to 14 (back).
struct CagePoint {
  HeadPart part;
  int ring, place;
  auto operator<=>(const CagePoint&) const = default;
};

/// What a quad of the skin is covered with.
enum class SkinKind : std::uint8_t { skin, lip, mouth, nostril, lash };

struct CageQuad {
  std::array<std::uint32_t, 4> corners;
  SkinKind kind;
};

/// Everything the parts are drawn from.
struct HeadPlan {
  explicit HeadPlan(const HeadMeasures& measures);

  HeadMeasures m;
  HeadLoft loft;
  double brow, eye, nose, mouth;  ///< heights
  double eye_scale;               ///< 1 for the adult's eye
  double lower_scale;             ///< of what lies below the eye: no more than fits above the nose
  double mouth_scale;             ///< 1 for the adult's mouth
  Vec3 eye_centre;
  double nasion;     ///< depth of the nose's root
  double nose_base;  ///< depth of the nose's base
  double lip_line;   ///< depth at which the lips meet in the middle
  double corner;     ///< depth of the mouth's corner
  /// Where the cheek bone stands forward, 0 to `cheek_bone`.
  double cheek_bone(double x, double y) const;
  /// How far a full cheek stands out beside the mouth.
  Vec3 cheek_puff(double x, double y) const;
  /// The lower edge of the jaw from beside the chin (0) to its angle (1).
  Vec3 jaw_edge(double t) const;
  /// The chin's lower edge: 0 the middle to 3 beside it.
  Vec3 chin_edge(int column) const;
  Vec3 jaw_angle() const { return {m.jaw_width, m.jaw_height, m.jaw_depth}; }
};

/// A direction from the eyeball's centre, radians: azimuth away from the middle, elevation up.
struct LidAngle {
  double azimuth, elevation;
  double along;  ///< 0 inner corner to 1 outer corner
};
/// The lid's margin at a place of the eye's rings.
LidAngle lid_margin(const HeadPlan& plan, int place);

class HeadCage {
 public:
  std::vector<Vec3> positions;
  std::vector<CagePoint> names;  ///< [positions]
  std::vector<CageQuad> quads;   ///< not yet wound alike

  std::uint32_t put(const CagePoint& name, const Vec3& position);
  std::uint32_t index(const CagePoint& name) const { return indices_.at(name); }
  const Vec3& at(const CagePoint& name) const { return positions[index(name)]; }
  Vec3& at(const CagePoint& name) { return positions[index(name)]; }
  void quad(const CagePoint& a, const CagePoint& b, const CagePoint& c, const CagePoint& d,
            SkinKind kind = SkinKind::skin);

 private:
  std::map<CagePoint, std::uint32_t> indices_;
};

/// The cage of the measures, all parts.
HeadCage build_head_cage(const HeadPlan& plan);

}  // namespace sinew
