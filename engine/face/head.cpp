#include "engine/face/head.h"

#include <algorithm>

#include "engine/deform/face.h"
#include "engine/face/head_cage_parts.h"
#include "engine/face/head_layout.h"
#include "engine/face/head_normals.h"
#include "engine/face/head_regions.h"
#include "engine/face/landmarks.h"

namespace sinew {
namespace {

HeadMaterial material_of(SkinKind kind) {
  switch (kind) {
    case SkinKind::lip:
      return HeadMaterial::lip;
    case SkinKind::mouth:
      return HeadMaterial::mouth;
    case SkinKind::nostril:
      return HeadMaterial::nostril;
    case SkinKind::lash:
      return HeadMaterial::lash;
    default:
      return HeadMaterial::skin;
  }
}

/// Quads cut along the diagonal that is shorter in the adult, in every head alike.
std::vector<HeadTriangle> skin_triangles(const HeadTopology& topology) {
  const std::vector<Vec3> p = topology.positions(topology.fitted(topology.cage().positions));
  HeadSurface out;
  for (std::size_t q = 0; q < topology.quads().size(); ++q) {
    const auto& [a, b, c, d] = topology.quads()[q];
    const HeadMaterial material = material_of(topology.kinds()[q]);
    if (glm::distance(p[a], p[c]) <= glm::distance(p[b], p[d]))
      out.quad(a, b, c, d, material);
    else
      out.quad(b, c, d, a, material);
  }
  return out.triangles;
}

/// Crown and chin exactly where the guide lines have them: the fit leaves them some hundredths short.
void set_extent(const HeadPlan& plan, std::uint32_t chin, std::vector<Vec3>& skin) {
  double top = 0.0;
  for (const Vec3& p : skin) top = std::max(top, p.y);
  const double low = skin[chin].y;
  for (Vec3& p : skin) {
    p.y += (head_units - top) * smoothstep01((p.y - plan.brow) / (top - plan.brow));
    p.y -= low * (1.0 - smoothstep01((p.y - low) / (0.7 * plan.mouth))) * smoothstep01((p.y - low + 0.8) / 0.8);
  }
}

class HeadBuilder {
 public:
  HeadBuilder(const HeadPlan& plan, const HeadTopology& topology, Head& head)
      : plan_(plan), topology_(topology), cage_(build_head_cage(plan)), head_(head) {}

  void add_skin(const std::vector<HeadTriangle>& triangles, const std::vector<Vec2>& layout) {
    std::vector<Vec3>& skin = head_.positions = topology_.positions(topology_.fitted(cage_.positions));
    set_extent(plan_, topology_.vertex_of(chin_point(3, 2)), skin);
    head_.face = skin_face(plan_, topology_, cage_, skin);
    push_out_of_eyes(head_.face, skin);
    head_.triangles = triangles;
    head_.texture_coordinates = layout;
    head_.mirror = topology_.mirror();
    head_.skin_vertices = skin.size();
  }

  void add_eyes() {
    const HeadSurface left = build_eyeball(plan_);
    for (int side = 0; side < 2; ++side)
      add(side == 0 ? left : left.mirrored(), [&](std::size_t) {
        FaceVertex vertex;
        vertex.eye = side;
        vertex.ball = true;
        return FaceBlend{vertex, {}};
      });
    mirror_last_two(left.positions.size());
  }

  void add_brows() {
    const Brow brow = build_brow(plan_, std::span(head_.positions).first(head_.skin_vertices));
    head_.face.brow_outline = brow.outline;
    for (int side = 0; side < 2; ++side)
      add(side == 0 ? brow.surface : brow.surface.mirrored(), [&](std::size_t i) {
        std::array<std::uint32_t, 6> anchors = brow.anchors[i];
        if (side == 1)
          for (std::uint32_t& v : anchors) v = topology_.mirror()[v];
        return blend_vertices(head_.face, anchors, brow.anchor_weights[i]);
      });
    mirror_last_two(brow.surface.positions.size());
  }

  void add_inside() {
    constexpr double upper_teeth = 0.0, lower_teeth = 1.0, tongue = 0.95;
    for (const double jaw : {upper_teeth, lower_teeth, tongue}) {
      const HeadSurface part = jaw == tongue ? build_tongue(plan_) : build_teeth(plan_, jaw == upper_teeth);
      const std::size_t first = head_.positions.size();
      add(part, [&](std::size_t) {
        FaceVertex vertex;
        vertex.jaw = vertex.jaw_sealed = jaw;
        return FaceBlend{vertex, {}};
      });
      for (std::size_t v = first; v < head_.positions.size(); ++v) {
        const Vec3& p = head_.positions[v];
        const auto found = std::find(head_.positions.begin() + static_cast<std::ptrdiff_t>(first),
                                     head_.positions.end(), Vec3(-p.x, p.y, p.z));
        head_.mirror.push_back(static_cast<std::uint32_t>(found - head_.positions.begin()));
      }
    }
  }

  void set_blush() {
    const HeadMeasures& m = plan_.m;
    const auto spot = [](const Vec3& p, const Vec3& at, const Vec3& reach) {
      const Vec3 d = (Vec3(std::abs(p.x), p.y, p.z) - at) / reach;
      return std::exp(-glm::dot(d, d));
    };
    const double tip = plan_.nose_base + m.nose_length;
    for (const Vec3& p : head_.positions) {
      const double cheek =
          spot(p, {1.22 * m.eye_spacing, glm::mix(plan_.nose, plan_.eye, 0.18), 1.2}, {0.30, 0.25, 0.6});
      const double nose = spot(p, {0.0, plan_.nose + m.nose_tip_rise, tip}, {0.18, 0.14, 0.20});
      const double ear =
          spot(p, {plan_.loft.at(90, plan_.eye).x + 0.18, glm::mix(m.ear_bottom, m.ear_top, 0.5), m.ear_depth - 0.05},
               {0.12, 0.42, 0.3});
      head_.blush.push_back(std::min(1.0, 0.65 * cheek + 0.35 * nose + 0.6 * ear));
    }
  }

  /// Teeth and tongue darken towards the corners of the mouth and towards the throat.
  void set_gloom(std::size_t first_inside) {
    const HeadMeasures& m = plan_.m;
    for (std::size_t v = 0; v < head_.positions.size(); ++v) {
      const Vec3& p = head_.positions[v];
      const double aside = (std::abs(p.x) / m.mouth_width - 0.40) / 0.40;
      const double behind = (plan_.lip_line - p.z - 0.25) / 0.5;
      head_.gloom.push_back(v < first_inside ? 0.0 : smoothstep01(std::max(aside, behind)));
    }
  }

  void set_landmarks() {
    const auto vertex = [&](const CagePoint& point) { return topology_.vertex_of(point); };
    std::uint32_t crown = 0, hair = 0;
    double highest = -INFINITY, nearest = INFINITY;
    for (std::uint32_t v = 0; v < head_.skin_vertices; ++v) {
      const Vec3& p = head_.positions[v];
      if (!topology_.on_mid_line(v)) continue;
      if (p.y > highest) highest = p.y, crown = v;
      const double off = std::abs(p.y - plan_.m.hair_line);
      if (p.z > 0 && off < nearest) nearest = off, hair = v;
    }
    head_.landmarks = {{"crown", crown},
                       {"hairLine", hair},
                       {"brow", vertex(nose_point(0, 0))},
                       {"eyeLine", vertex(nose_point(0, 2))},
                       {"noseBase", vertex(mouth_point(6, 0))},
                       {"lipContact", vertex(mouth_point(2, 0))},
                       {"chin", vertex(chin_point(3, 2))},
                       {"earTop", vertex(ear_point(2, 17))},
                       {"earBottom", vertex(ear_point(2, 8))}};
    for (const LandmarkName& l : landmark_names()) {
      const std::uint32_t left = vertex(l.place);
      head_.marks[l.name] = l.right ? topology_.mirror()[left] : left;
    }
  }

  void set_lip_line() {
    for (int j = 0; j < 5; ++j) {
      const std::uint32_t upper = topology_.vertex_of(mouth_point(2, j)),
                          lower = topology_.vertex_of(mouth_point(2, 10 - j));
      head_.lip_line.push_back({upper, lower});
      if (j > 0) head_.lip_line.push_back({topology_.mirror()[upper], topology_.mirror()[lower]});
    }
  }

 private:
  template <class FaceOf>
  void add(const HeadSurface& part, const FaceOf& face_of) {
    const auto first = static_cast<std::uint32_t>(head_.positions.size());
    Bounds bounds;
    for (const Vec3& p : part.positions) bounds.add(p);
    const Vec3 size = glm::max(bounds.high - bounds.low, Vec3(1e-9));
    for (std::size_t i = 0; i < part.positions.size(); ++i) {
      const Vec3& p = part.positions[i];
      const FaceBlend face = face_of(i);
      append_vertex(face.vertex, face.deltas, head_.face);
      head_.texture_coordinates.emplace_back((p.x - bounds.low.x) / size.x, (bounds.high.y - p.y) / size.y);
    }
    head_.positions.insert(head_.positions.end(), part.positions.begin(), part.positions.end());
    for (HeadTriangle t : part.triangles) {
      for (std::uint32_t& corner : t.corners) corner += first;
      head_.triangles.push_back(t);
    }
  }
  void mirror_last_two(std::size_t size) {
    const auto left = static_cast<std::uint32_t>(head_.positions.size() - 2 * size);
    const auto n = static_cast<std::uint32_t>(size);
    for (std::uint32_t i = 0; i < n; ++i) head_.mirror.push_back(left + n + i);
    for (std::uint32_t i = 0; i < n; ++i) head_.mirror.push_back(left + i);
  }

  const HeadPlan& plan_;
  const HeadTopology& topology_;
  HeadCage cage_;
  Head& head_;
};

}  // namespace

FaceGuides head_guides(const HeadMeasures& m) {
  return {head_units, m.hair_line, m.brow_height, m.eye_height, m.nose_height, m.mouth_height, 0.0};
}

struct HeadMaker::Impl {
  explicit Impl(int level) : topology(level), triangles(skin_triangles(topology)), layout(skin_layout(topology)) {}
  HeadTopology topology;
  std::vector<HeadTriangle> triangles;
  std::vector<Vec2> layout;
};

HeadMaker::HeadMaker(int level) : impl_(std::make_unique<Impl>(level)) {}
HeadMaker::~HeadMaker() = default;
HeadMaker::HeadMaker(HeadMaker&&) noexcept = default;

Result<Head> HeadMaker::head(const HeadMeasures& measures) const {
  if (auto ok = check_measures(measures); !ok) return pass_on(std::move(ok));
  const HeadPlan plan(measures);
  Head out;
  out.measures = measures;
  HeadBuilder builder(plan, impl_->topology, out);
  builder.add_skin(impl_->triangles, impl_->layout);
  builder.add_eyes();
  builder.add_brows();
  const std::size_t first_inside = out.positions.size();
  builder.add_inside();
  builder.set_blush();
  builder.set_gloom(first_inside);
  builder.set_landmarks();
  builder.set_lip_line();
  out.normals = head_normals(out, out.positions);
  for (std::uint32_t v = 0; v < out.normals.size(); ++v) {
    const Vec3 n = out.normals[v];
    if (out.mirror[v] > v) out.normals[out.mirror[v]] = {-n.x, n.y, n.z};
    if (out.mirror[v] == v) out.normals[v] = unit_or({0.0, n.y, n.z}, n);
  }
  add_normal_deltas(out);
  return out;
}

std::vector<Vec3> posed_positions(const Head& head, const FaceChannels& channels) {
  std::vector<Vec3> out(head.positions.size());
  const FaceState state = face_state(head.face, channels);
  FaceJob{head.face, state, head.positions, {}, out, {}}.run();
  return out;
}

}  // namespace sinew
