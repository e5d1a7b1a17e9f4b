#include "engine/body/limb_surface.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "engine/deform/muscle_region.h"

namespace sinew {
namespace {

/// Of the rest pose's diagonal: vertices nearer than this stand at one place.
constexpr double weld_reach = 1e-7;
/// A line belongs to a limb where more than this part of it does.
constexpr double own_share = 0.6;
/// A line that ends is closed where its gap is no longer than this part of it: a hole that a tape would lie across.
constexpr double bridged_gap = 0.15;

using Edge = std::pair<std::uint32_t, std::uint32_t>;

struct Plane {
  Vec3 point, normal;
  double distance(const Vec3& p) const { return glm::dot(p - point, normal); }
};

/// The piece of the cut that lies in one triangle, between the two edges that it crosses.
struct Piece {
  std::array<std::size_t, 2> ends;  ///< indices of crossings
  std::uint32_t triangle;
};

/// All that a plane cuts: a crossing for every edge, a piece for every triangle.
struct Cut {
  std::vector<Vec3> crossings;
  std::vector<Piece> pieces;
  std::vector<std::vector<std::size_t>> pieces_at;  ///< [crossings] indices of pieces
};

Cut cut_surface(const PosedSurface& surface, const Plane& plane) {
  Cut cut;
  std::map<Edge, std::size_t> known;
  const auto crossing = [&](std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const auto [found, is_new] = known.try_emplace({a, b}, cut.crossings.size());
    if (is_new) {
      const double da = plane.distance(surface.positions[a]), db = plane.distance(surface.positions[b]);
      cut.crossings.push_back(glm::mix(surface.positions[a], surface.positions[b], da / (da - db)));
      cut.pieces_at.emplace_back();
    }
    return found->second;
  };
  for (std::size_t i = 0; i + 2 < surface.triangles.size(); i += 3) {
    std::array<std::size_t, 3> ends{};
    std::size_t count = 0;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t a = surface.triangles[i + corner], b = surface.triangles[i + (corner + 1) % 3];
      if ((plane.distance(surface.positions[a]) < 0.0) != (plane.distance(surface.positions[b]) < 0.0))
        ends[count++] = crossing(a, b);
    }
    if (count != 2 || ends[0] == ends[1]) continue;
    for (const std::size_t end : {ends[0], ends[1]}) cut.pieces_at[end].push_back(cut.pieces.size());
    cut.pieces.push_back({{ends[0], ends[1]}, static_cast<std::uint32_t>(i / 3)});
  }
  return cut;
}

/// Crossings in order, and the pieces between them.
struct Line {
  std::vector<std::size_t> crossings, pieces;
  bool closed = false;
};

/// Goes on from the line's last crossing as long as there are unused pieces.
void follow(const Cut& cut, std::vector<bool>& used, Line& line) {
  for (;;) {
    const std::size_t at = line.crossings.back();
    const auto& here = cut.pieces_at[at];
    const auto next = std::find_if(here.begin(), here.end(), [&](std::size_t piece) { return !used[piece]; });
    if (next == here.end()) return;
    used[*next] = true;
    const auto& ends = cut.pieces[*next].ends;
    line.pieces.push_back(*next);
    line.crossings.push_back(ends[0] == at ? ends[1] : ends[0]);
    if (line.crossings.back() == line.crossings.front()) {
      line.crossings.pop_back();
      line.closed = true;
      return;
    }
  }
}

std::vector<Line> lines_of(const Cut& cut) {
  std::vector<Line> lines;
  std::vector<bool> used(cut.pieces.size());
  for (std::size_t first = 0; first < cut.pieces.size(); ++first) {
    if (used[first]) continue;
    Line line;
    line.crossings.push_back(cut.pieces[first].ends[0]);
    follow(cut, used, line);
    if (!line.closed) {
      std::reverse(line.crossings.begin(), line.crossings.end());
      follow(cut, used, line);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

double piece_length(const Cut& cut, std::size_t piece) {
  const auto& ends = cut.pieces[piece].ends;
  return glm::distance(cut.crossings[ends[0]], cut.crossings[ends[1]]);
}

/// How a line lies to the limb.
struct Standing {
  bool own = false;       ///< it is the limb's
  bool round = false;     ///< it goes round the axis
  double area = 0.0;      ///< inside it
  double distance = 0.0;  ///< from the axis to its nearest crossing
};

Standing standing_of(const PosedSurface& surface, const std::vector<bool>& in_segment, const Cut& cut, const Line& line,
                     const Plane& plane) {
  Standing standing;
  double whole = 0.0, own = 0.0;
  for (const std::size_t piece : line.pieces) {
    const double length = piece_length(cut, piece);
    const std::uint32_t* corner = &surface.triangles[3 * cut.pieces[piece].triangle];
    whole += length;
    if (std::any_of(corner, corner + 3, [&](std::uint32_t v) { return in_segment[surface.mesh.bone(v)]; }))
      own += length;
  }
  const double gap =
      line.closed ? 0.0 : glm::distance(cut.crossings[line.crossings.front()], cut.crossings[line.crossings.back()]);
  standing.own = own > own_share * whole && gap <= bridged_gap * whole;
  double turned = 0.0;
  Vec3 twice_area(0.0);
  standing.distance = INFINITY;
  for (std::size_t i = 0; i < line.crossings.size(); ++i) {
    const Vec3 a = cut.crossings[line.crossings[i]] - plane.point,
               b = cut.crossings[line.crossings[(i + 1) % line.crossings.size()]] - plane.point;
    const Vec3 across = glm::cross(a, b);
    turned += std::atan2(glm::dot(across, plane.normal), glm::dot(a, b));
    twice_area += across;
    standing.distance = std::min(standing.distance, glm::length(a));
  }
  standing.round = std::abs(turned) > std::numbers::pi;
  standing.area = 0.5 * glm::length(twice_area);
  return standing;
}

bool better(const Standing& a, const Standing& b) {
  if (a.round != b.round) return a.round;
  return a.round ? a.area > b.area : a.distance < b.distance;
}

}  // namespace

std::vector<std::uint32_t> welded_triangles(const CharacterMesh& mesh, const RestShape& rest) {
  Bounds bounds;
  for (const Vec3& p : rest.positions) bounds.add(p);
  const double cell = std::max(weld_reach * bounds.diagonal(), 1e-300);
  std::map<std::array<long long, 3>, std::uint32_t> first;
  std::vector<std::uint32_t> representative(mesh.vertices());
  for (std::uint32_t v = 0; v < mesh.vertices(); ++v) {
    const Vec3 at = (rest.positions[v] - bounds.low) / cell;
    representative[v] =
        first.try_emplace({std::llround(at.x), std::llround(at.y), std::llround(at.z)}, v).first->second;
  }
  std::vector<std::uint32_t> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const std::uint32_t v : mesh.triangles) triangles.push_back(representative[v]);
  return triangles;
}

Result<LimbSection> limb_section(const PosedSurface& surface, int joint, int child, double at) {
  const Vec3 from(surface.global[joint][3]), to(surface.global[child][3]);
  const std::string& name = surface.model.nodes[joint].name;
  if (glm::distance(from, to) < 1e-12)
    return bad_input("joint \"{}\": stands where the joint after it does; there is no limb to cut", name);
  const Plane plane{glm::mix(from, to, at), glm::normalize(to - from)};
  const std::vector<bool> in_segment = segment_nodes(surface.model, joint, child);
  const Cut cut = cut_surface(surface, plane);
  const Line* best = nullptr;
  Standing best_standing;
  const std::vector<Line> lines = lines_of(cut);
  for (const Line& line : lines) {
    const Standing standing = standing_of(surface, in_segment, cut, line, plane);
    if (!standing.own || (best && !better(standing, best_standing))) continue;
    best = &line;
    best_standing = standing;
  }
  if (!best)
    return bad_input(
        "joint \"{}\": at {} of its length no closed line of the surface goes round this limb alone; try a place "
        "further from where it joins another",
        name, at);
  LimbSection section{plane.point, plane.normal, {}, cut.pieces[best->pieces.front()].triangle};
  for (const std::size_t crossing : best->crossings) section.line.push_back(cut.crossings[crossing]);
  return section;
}

}  // namespace sinew
