#include "engine/body/neck_fit.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "engine/face/head_model.h"

namespace sinew {
namespace {

/// Rows of the head's cage from the base of its neck: how many are left out, and to which the fit reaches: the jaw in
/// front, and at the back, from the first of these angles to the second, the skull.
constexpr int dropped_rows = 3, rows_in_front = 6, rows_at_back = 18;
constexpr double back_begins = 50.0 * degrees_to_radians, back_whole = 100.0 * degrees_to_radians;
/// The head's lowest ring stays this far above the border, metres for each metre of body: between them lies a band.
constexpr double band = 0.0012;
constexpr int surface_steps = 6;
/// The nape is evened out by going half way to the neighbours' mean so often on the cage; four times as often on each
/// finer level, to reach as far.
constexpr int evening_rounds = 3;

using Neighbours = std::vector<std::vector<std::uint32_t>>;  ///< [skin vertices]

/// Rows of the skin's vertices, from the base of the neck up: each the next that edges lead to.
std::vector<std::vector<std::uint32_t>> neck_rows(const Head& head, std::size_t count, Neighbours& neighbours) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  neighbours.resize(head.skin_vertices);
  for (const HeadTriangle& t : head.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t a = t.corners[c], b = t.corners[(c + 1) % 3];
      if (a >= head.skin_vertices || b >= head.skin_vertices) continue;
      ++uses[std::minmax(a, b)];
      neighbours[a].push_back(b);
      neighbours[b].push_back(a);
    }
  // Other borders of the skin, the sleeves inside the eyes, lie above the chin.
  std::set<std::uint32_t> base;
  for (const auto& [edge, n] : uses)
    if (n == 1 && head.positions[edge.first].y < 0.0) base.insert({edge.first, edge.second});
  std::vector<std::vector<std::uint32_t>> rows{{base.begin(), base.end()}};
  std::set<std::uint32_t> seen = base;
  while (rows.size() < count) {
    std::set<std::uint32_t> next;
    for (const std::uint32_t v : rows.back())
      for (const std::uint32_t n : neighbours[v])
        if (!seen.contains(n)) next.insert(n);
    seen.insert(next.begin(), next.end());
    rows.emplace_back(next.begin(), next.end());
  }
  return rows;
}

/// Moves a vertex of the left half, and its mirror image.
void set_both(Head& head, std::uint32_t v, Vec3 p) {
  const std::uint32_t other = head.mirror[v];
  if (other == v) p.x = 0.0;
  head.positions[other] = {-p.x, p.y, p.z};
  head.positions[v] = p;
}

/// What moves the skin of a face fades out towards the lowest ring, which hangs on the figure.
void fade_face(const std::vector<double>& share, FaceRig& face) {
  constexpr double whole = 0.4;  // share from which all of it counts
  for (std::size_t v = 0; v < share.size(); ++v) {
    if (share[v] >= whole) continue;
    const double moved = smoothstep01(share[v] / whole);
    face.vertices[v].jaw *= moved;
    face.vertices[v].jaw_sealed *= moved;
    for (std::uint32_t i = face.first[v]; i < face.first[v + 1]; ++i) {
      face.deltas[i].position *= moved;
      face.deltas[i].normal *= moved;
    }
  }
}

/// Evens out the skin of the left half where it gives way, and the right half with it.
void even_out(const Neighbours& neighbours, const std::map<std::uint32_t, double>& gives, int rounds, Head& head) {
  for (int round = 0; round < rounds; ++round) {
    std::vector<std::pair<std::uint32_t, Vec3>> evened;
    for (const auto& [v, share] : gives) {
      Vec3 mean(0.0);
      for (const std::uint32_t n : neighbours[v]) mean += head.positions[n];
      mean /= static_cast<double>(neighbours[v].size());
      evened.emplace_back(v, glm::mix(head.positions[v], mean, 0.5 * share));
    }
    for (const auto& [v, p] : evened) set_both(head, v, p);
  }
}

}  // namespace

NeckBorder::NeckBorder(const Primitive& skin, const std::vector<BorderEdge>& edges) : skin_(skin), edges_(edges) {
  Bounds bounds;
  for (const BorderEdge& edge : edges) bounds.add(skin.positions[edge.from]);
  centre_ = {0.0, 0.0, 0.5 * (bounds.low.z + bounds.high.z)};
  const auto middle = [&](const BorderEdge& edge) {
    return angle(0.5 * (skin_.positions[edge.from] + skin_.positions[edge.to]));
  };
  std::ranges::sort(edges_, {}, middle);
}

double NeckBorder::angle(const Vec3& p) const {
  const Vec3 d = p - centre_;
  return std::abs(d.x) < 1e-12 ? (d.z > 0.0 ? 0.0 : std::numbers::pi) : std::atan2(d.x, d.z);
}

NeckBorder::Place NeckBorder::at(double wanted) const {
  // Of the edge whose end comes first behind the angle; the last ends at the back.
  const auto end =
      std::ranges::find_if(edges_, [&](const BorderEdge& edge) { return wanted <= angle(skin_.positions[edge.to]); });
  const BorderEdge& edge = end == edges_.end() ? edges_.back() : *end;
  const Vec3 &a = skin_.positions[edge.from], &b = skin_.positions[edge.to];
  // Where the ray from the centre meets the edge.
  const Vec2 ray(std::cos(wanted), -std::sin(wanted));  // across the ray, in (x, z)
  const auto across = [&](const Vec3& p) { return ray.x * (p.x - centre_.x) + ray.y * (p.z - centre_.z); };
  const double share = std::clamp(across(a) / (across(a) - across(b)), 0.0, 1.0);
  return {glm::mix(a, b, share), edge.from, edge.to, share};
}

NeckFit fit_neck(const BuiltFigure& figure, const BodyField& field, const NeckBorder& border, const Vec3& origin,
                 int level, Head& head) {
  const int a_row = 1 << level;
  Neighbours neighbours;
  const auto rows = neck_rows(head, static_cast<std::size_t>(rows_at_back * a_row) + 1, neighbours);
  const auto lowest = static_cast<std::size_t>(dropped_rows * a_row);
  const double unit = head.metres();
  const auto in_body = [&](std::uint32_t v) { return origin + unit * head.positions[v]; };
  const auto onto_surface = [&](Vec3 p) {
    p = figure.scale.to_units(p);
    Vec3 normal{0.0};
    for (int i = 0; i < surface_steps; ++i) normal = field.step_to_surface(p);
    return std::pair{figure.scale.to_metres(p), normal};
  };

  NeckFit out;
  out.ring = rows[lowest];
  std::ranges::sort(out.ring, {}, [&](std::uint32_t v) { return border.angle(in_body(v)); });
  std::ranges::rotate(out.ring, out.ring.end() - 1);  // the one at the back had the largest angle
  // How far each of the lowest ring has to go, by its angle.
  std::map<double, Vec3> moves;
  for (const std::uint32_t v : out.ring) {
    const double angle = border.angle(in_body(v));
    const Vec3 place = border.at(angle).position + Vec3(0.0, band * figure.scale.scale, 0.0);
    moves[angle] = onto_surface(place).first - in_body(v);
  }
  moves[-std::numbers::pi] = moves.rbegin()->second;
  const auto move_at = [&](double angle) {
    const auto above = moves.lower_bound(angle);
    if (above == moves.begin()) return above->second;
    const auto below = std::prev(above);
    return glm::mix(below->second, above->second, (angle - below->first) / (above->first - below->first));
  };

  out.share.assign(head.skin_vertices, 1.0);
  std::vector<bool> dropped(head.positions.size(), false);
  for (std::size_t r = 0; r < lowest; ++r)
    for (const std::uint32_t v : rows[r]) dropped[v] = true;
  std::map<std::uint32_t, double> gives;  // of the left half: how far evening out may move it
  std::map<std::uint32_t, Vec3> figure_normals;
  for (std::size_t r = lowest; r + 1 < rows.size(); ++r)
    for (const std::uint32_t v : rows[r]) {
      const Vec3 p = in_body(v);
      const double back = smoothstep01((std::abs(border.angle(p)) - back_begins) / (back_whole - back_begins));
      const double reach = a_row * (glm::mix<double>(rows_in_front, rows_at_back, back) - dropped_rows);
      const double own = smoothstep01(static_cast<double>(r - lowest) / reach);
      out.share[v] = own;
      if (head.positions[v].x < 0.0 || own == 1.0) continue;
      const Vec3 fitted = p + (1.0 - own) * move_at(border.angle(p));
      const auto [on_figure, normal] = onto_surface(fitted);
      figure_normals[v] = normal;
      gives[v] = back * 4.0 * own * (1.0 - own);
      set_both(head, v, (glm::mix(fitted, on_figure, 1.0 - own) - origin) / unit);
    }
  fade_face(out.share, head.face);
  even_out(neighbours, gives, evening_rounds * a_row * a_row, head);
  std::erase_if(head.triangles, [&](const HeadTriangle& t) {
    return std::ranges::any_of(t.corners, [&](std::uint32_t v) { return dropped[v]; });
  });

  // Above the lowest ring as the triangles stand, near it as the figure's surface does.
  const std::vector<Vec3> normals = head_normals(head, head.positions);
  for (std::size_t r = lowest; r < rows.size(); ++r)
    for (const std::uint32_t v : rows[r]) head.normals[v] = normals[v];
  for (const auto& [v, normal] : figure_normals) {
    const Vec3 n = unit_or(glm::mix(normals[v], normal, 1.0 - out.share[v]), normals[v]);
    head.normals[v] = n;
    if (head.mirror[v] != v) head.normals[head.mirror[v]] = {-n.x, n.y, n.z};
  }
  return out;
}

}  // namespace sinew
