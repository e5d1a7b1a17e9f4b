#include "engine/render/face_overlay.h"

#include <functional>

namespace sinew {
namespace {

/// A face's mesh as both the drawing space and the picture have it.
class PosedFace {
 public:
  PosedFace(const CharacterMesh& mesh, std::span<const Vec3> positions, std::span<const Mat3> blend)
      : mesh_(mesh), face_(*mesh.face), positions_(positions) {
    const FacePlace& place = face_.place;
    const Mat3 back = glm::transpose(place.axes);
    for (const Vec3& p : mesh.positions) drawn_.push_back(back * (p - place.origin) / place.unit);
    // The skin between the eyes carries what is drawn in the air.
    const Vec3 between =
        0.5 * (face_.rig.eye_centres[0] + face_.rig.eye_centres[1]) + Vec3(0, 0.2, face_.rig.eye_radius);
    double nearest = INFINITY;
    for (std::size_t v = 0; v < drawn_.size(); ++v)
      if (const double d = glm::distance(drawn_[v], between); d < nearest) nearest = d, carrier_ = v;
    carry_ = blend[carrier_];
  }

  const CharacterFace& face() const { return face_; }
  std::size_t vertices() const { return drawn_.size(); }
  const Vec3& drawn(std::size_t v) const { return drawn_[v]; }
  const Vec3& posed(std::size_t v) const { return positions_[v]; }

  /// A place of the drawing space that rides on the head.
  Vec3 riding(const Vec3& d) const {
    return positions_[carrier_] + carry_ * (face_.place.axes * (face_.place.unit * (d - drawn_[carrier_])));
  }

  /// Where a value passes a level on the triangles whose three corners take part.
  std::vector<SurfaceCut> cuts(const std::function<double(std::size_t)>& value, double level,
                               const std::function<bool(std::size_t)>& takes_part,
                               std::vector<Vec3>* middles = nullptr) const {
    std::vector<SurfaceCut> out;
    for (std::size_t i = 0; i + 2 < mesh_.triangles.size(); i += 3) {
      const std::uint32_t* t = &mesh_.triangles[i];
      if (!takes_part(t[0]) || !takes_part(t[1]) || !takes_part(t[2])) continue;
      Vec3 posed[2], drawn[2];
      int found = 0;
      for (int k = 0; k < 3 && found < 2; ++k) {
        const std::uint32_t a = t[k], b = t[(k + 1) % 3];
        const double x = value(a) - level, y = value(b) - level;
        if ((x < 0) == (y < 0)) continue;
        const double share = x / (x - y);
        posed[found] = glm::mix(positions_[a], positions_[b], share);
        drawn[found++] = glm::mix(drawn_[a], drawn_[b], share);
      }
      if (found < 2) continue;
      const Vec3 normal = glm::cross(positions_[t[1]] - positions_[t[0]], positions_[t[2]] - positions_[t[0]]);
      out.push_back({posed[0], posed[1], unit_or(normal, Vec3(0, 0, 1))});
      if (middles) middles->push_back(0.5 * (drawn[0] + drawn[1]));
    }
    return out;
  }

  std::vector<std::array<Vec3, 3>> area(const std::function<double(std::size_t)>& value, double level) const {
    std::vector<std::array<Vec3, 3>> out;
    for (std::size_t i = 0; i + 2 < mesh_.triangles.size(); i += 3) {
      const std::uint32_t* t = &mesh_.triangles[i];
      if (value(t[0]) + value(t[1]) + value(t[2]) >= 3.0 * level)
        out.push_back({positions_[t[0]], positions_[t[1]], positions_[t[2]]});
    }
    return out;
  }

 private:
  const CharacterMesh& mesh_;
  const CharacterFace& face_;
  std::span<const Vec3> positions_;
  std::vector<Vec3> drawn_;
  std::size_t carrier_ = 0;
  Mat3 carry_{1.0};
};

/// The outermost of a section's pieces, as seen from its middle: mouth, eyes and what lies behind stay out.
std::vector<SurfaceCut> outermost(const std::vector<SurfaceCut>& cuts, const std::vector<Vec3>& middles,
                                  const std::function<Vec2(const Vec3&)>& in_plane) {
  constexpr int sectors = 180;
  constexpr double near = 0.93;
  std::vector<double> far(sectors, 0.0);
  const auto sector = [&](const Vec2& p) {
    return std::min(sectors - 1, int((std::atan2(p.y, p.x) / (2 * std::numbers::pi) + 0.5) * sectors));
  };
  for (const Vec3& m : middles) {
    const Vec2 p = in_plane(m);
    double& here = far[static_cast<std::size_t>(sector(p))];
    here = std::max(here, glm::length(p));
  }
  std::vector<SurfaceCut> out;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const Vec2 p = in_plane(middles[i]);
    const int s = sector(p);
    double most = 0.0;
    for (int k = -1; k <= 1; ++k) most = std::max(most, far[static_cast<std::size_t>((s + k + sectors) % sectors)]);
    if (glm::length(p) > near * most) out.push_back(cuts[i]);
  }
  return out;
}

std::vector<FaceGuideLine> guide_lines(const PosedFace& face) {
  // Round the head alone: no shoulder or hand lies in this box.
  const auto of_head = [&](std::size_t v) {
    const Vec3& d = face.drawn(v);
    return std::abs(d.x) < 1.7 && d.y > -0.35 && d.y < 3.9 && std::abs(d.z) < 2.4 && !face.face().rig.vertices[v].ball;
  };
  std::vector<FaceGuideLine> out;
  const double eyes = face.face().rig.eye_centres[0].y;
  for (const FaceGuideName& guide : face_guide_names()) {
    const double height = face.face().guides.*guide.height;
    if (!std::isfinite(height)) continue;
    std::vector<Vec3> middles;
    // At the crown and under the chin the section itself would shrink to a point.
    const double level = guide.height == &FaceGuides::crown ? height - 0.03 : height;
    const auto cuts = face.cuts([&](std::size_t v) { return face.drawn(v).y; }, level, of_head, &middles);
    out.push_back({guide.words, outermost(cuts, middles, [](const Vec3& p) { return Vec2(p.x, p.z); })});
  }
  const auto upright = [&](const char* name, int axis) {
    std::vector<Vec3> middles;
    const auto cuts = face.cuts([&](std::size_t v) { return face.drawn(v)[axis]; }, 1e-6, of_head, &middles);
    out.push_back(
        {name, outermost(cuts, middles, [&](const Vec3& p) { return Vec2(axis == 0 ? p.z : p.x, p.y - eyes); })});
  };
  upright("centre line", 0);
  upright("", 2);
  return out;
}

class RegionMaker {
 public:
  explicit RegionMaker(const PosedFace& face) : face_(face), rig_(face.face().rig) {}

  /// How much of its way each vertex goes, 1 at the most.
  using Share = std::function<double(std::size_t)>;

  double delta(std::size_t v, std::size_t signal) const {
    for (std::uint32_t i = rig_.first[v]; i < rig_.first[v + 1]; ++i)
      if (rig_.deltas[i].signal == signal) return glm::length(rig_.deltas[i].position);
    return 0.0;
  }
  FaceRegionOverlay& add(const std::string& name, const Colour& colour, const Share& share) {
    std::vector<double> values;
    double most = 0.0;
    for (std::size_t v = 0; v < face_.vertices(); ++v) most = std::max(most, values.emplace_back(share(v)));
    FaceRegionOverlay region{name, colour, {}, {}, {}, {}, {}, Vec3(0.0)};
    if (most > 0.0) {
      const double level = 0.5 * most;
      const auto value = [&](std::size_t v) { return values[v]; };
      region.area = face_.area(value, level);
      region.outline = face_.cuts(value, level, [](std::size_t) { return true; });
      double weight = 0.0;
      for (std::size_t v = 0; v < face_.vertices(); ++v)
        if (values[v] >= level && face_.drawn(v).z > 0.0) {
          region.anchor += values[v] * face_.posed(v);
          middle_ = weight == 0.0 ? values[v] * face_.drawn(v) : middle_ + values[v] * face_.drawn(v);
          weight += values[v];
        }
      if (weight > 0.0) {
        region.anchor /= weight;
        middle_ /= weight;
      }
    }
    all_.push_back(std::move(region));
    return all_.back();
  }
  /// Of the region that was added last, drawing units.
  const Vec3& middle() const { return middle_; }
  std::vector<Vec3> box(double left, double right, double low, double high, double z) const {
    return {face_.riding({left, low, z}), face_.riding({right, low, z}), face_.riding({right, high, z}),
            face_.riding({left, high, z})};
  }
  std::vector<FaceRegionOverlay> take() {
    std::erase_if(all_, [](const FaceRegionOverlay& r) { return r.area.empty(); });
    return std::move(all_);
  }

 private:
  const PosedFace& face_;
  const FaceRig& rig_;
  Vec3 middle_{0.0};
  std::vector<FaceRegionOverlay> all_;
};

constexpr Colour brow_colour{120, 78, 196}, lid_colour{0, 128, 140}, ball_colour{32, 96, 208}, lip_colour{200, 36, 72},
    corner_colour{222, 112, 20}, jaw_colour{60, 132, 52}, helper_colour{120, 112, 96};

void add_upper_regions(const PosedFace& face, int side, RegionMaker& make) {
  const FaceRig& rig = face.face().rig;
  const FaceLimits& l = rig.limits;
  const std::string end = side == 0 ? "Left" : "Right";
  const auto at = static_cast<std::size_t>(side);
  const double outward = side == 0 ? 1.0 : -1.0;
  FaceRegionOverlay& brow = make.add(
      "brow" + end, brow_colour, [&](std::size_t v) { return make.delta(v, signal_index(FaceSignal::brow_up, at)); });
  if (!rig.brow_outline.empty() && !brow.area.empty()) {
    Vec2 low(INFINITY), high(-INFINITY);
    for (const Vec2& p : rig.brow_outline) low = glm::min(low, p), high = glm::max(high, p);
    const double z = make.middle().z + 0.06;
    brow.limits.push_back(make.box(outward * (low.x - l.eyebrow_in_horizontal),
                                   outward * (high.x + l.eyebrow_out_horizontal), low.y - l.eyebrow_down_vertical,
                                   high.y + l.eyebrow_up_vertical, z));
    for (const double x : {rig.brow_inner, rig.brow_outer})
      brow.pivots.push_back(face.riding({outward * x, 0.5 * (low.y + high.y), z}));
  }
  for (const bool upper : {true, false}) {
    FaceRegionOverlay& lid = make.add((upper ? "upperLid" : "lowerLid") + end, lid_colour, [&](std::size_t v) {
      const FaceVertex& vertex = rig.vertices[v];
      return vertex.eye == side && !vertex.ball ? (upper ? vertex.close_upper : vertex.close_lower) : 0.0;
    });
    // A lid turns about the line through its ball.
    const Vec3 along(1.15 * rig.eye_radius, 0, 0);
    if (upper && !lid.area.empty())
      lid.hinges.push_back({face.riding(rig.eye_centres[at] - along), face.riding(rig.eye_centres[at] + along)});
  }
  FaceRegionOverlay& ball = make.add("eye" + end, ball_colour, [&](std::size_t v) {
    return rig.vertices[v].ball && rig.vertices[v].eye == side ? 1.0 : 0.0;
  });
  ball.area.clear();
  ball.outline.clear();
  ball.anchor = face.riding(rig.eye_centres[at] + Vec3(0, 0, rig.eye_radius));
  const auto reach = [&](double degrees) { return rig.eye_radius * std::sin(degrees * degrees_to_radians); };
  const Vec3& c = rig.eye_centres[at];
  ball.limits.push_back(make.box(c.x - reach(l.eyeball_yaw), c.x + reach(l.eyeball_yaw), c.y - reach(l.eyeball_down),
                                 c.y + reach(l.eyeball_up), c.z + rig.eye_radius));
  ball.pivots.push_back(face.riding(c));
  bool has_ball = false;
  for (const FaceVertex& vertex : rig.vertices) has_ball = has_ball || (vertex.ball && vertex.eye == side);
  if (has_ball) ball.area.push_back({ball.anchor, ball.anchor, ball.anchor});
}

void add_lower_regions(const PosedFace& face, RegionMaker& make) {
  const FaceRig& rig = face.face().rig;
  const FaceLimits& l = rig.limits;
  for (const bool upper : {true, false}) {
    FaceRegionOverlay& lip = make.add(upper ? "upperLip" : "lowerLip", lip_colour, [&](std::size_t v) {
      return upper ? make.delta(v, signal_index(FaceMiddleSignal::upper_lip_up))
                   : std::max(make.delta(v, signal_index(FaceMiddleSignal::lower_lip_up)),
                              make.delta(v, signal_index(FaceMiddleSignal::lower_lip_down)));
    });
    const Vec3 m = make.middle();
    if (!lip.area.empty() && std::isfinite(face.face().guides.lip_contact)) {
      const double y = face.face().guides.lip_contact, half = 0.10 * rig.mouth_scale;
      lip.limits.push_back(upper ? make.box(-half, half, y, y + l.lip_up, m.z + 0.1)
                                 : make.box(-half, half, y - l.lip_down, y, m.z + 0.1));
    }
  }
  for (const int side : {0, 1}) {
    const double outward = side == 0 ? 1.0 : -1.0;
    FaceRegionOverlay& corner = make.add(side == 0 ? "cornerLeft" : "cornerRight", corner_colour, [&](std::size_t v) {
      return make.delta(v, signal_index(FaceSignal::corner_up, static_cast<std::size_t>(side)));
    });
    const Vec3 m = make.middle();
    if (!corner.area.empty())
      corner.limits.push_back(make.box(m.x - outward * l.corner_in, m.x + outward * l.corner_out, m.y - l.corner_down,
                                       m.y + l.corner_up, m.z + 0.08));
  }
  FaceRegionOverlay& jaw = make.add("jaw", jaw_colour, [&](std::size_t v) { return rig.vertices[v].jaw; });
  if (!jaw.area.empty()) {
    const double chin = rig.hinge.y - rig.chin_fall, z = rig.hinge.z + rig.chin_reach;
    jaw.limits.push_back(make.box(-0.16, 0.16, chin - l.chin_drop, chin, z));
    jaw.hinges.push_back({face.riding(rig.hinge - Vec3(1.25, 0, 0)), face.riding(rig.hinge + Vec3(1.25, 0, 0))});
    jaw.anchor = face.riding({0.0, chin + 0.1, z + 0.05});
  }
  for (const int side : {0, 1})
    make.add(side == 0 ? "cheekLeft" : "cheekRight", helper_colour, [&](std::size_t v) {
      return make.delta(v, signal_index(FaceSignal::cheek_up, static_cast<std::size_t>(side)));
    });
  make.add("nose", helper_colour, [&](std::size_t v) { return make.delta(v, signal_index(FaceMiddleSignal::nose)); });
}

}  // namespace

FaceOverlay posed_face(const CharacterMesh& mesh, std::span<const Vec3> positions, std::span<const Mat3> blend,
                       bool guides, bool regions) {
  const PosedFace face(mesh, positions, blend);
  FaceOverlay out;
  if (guides) out.guides = guide_lines(face);
  if (regions) {
    RegionMaker make(face);
    for (const int side : {0, 1}) add_upper_regions(face, side, make);
    add_lower_regions(face, make);
    out.regions = make.take();
  }
  return out;
}

}  // namespace sinew
