#include "engine/face/face_mesh.h"

#include <algorithm>

#include <Eigen/Dense>

#include "engine/face/fitted_ball.h"
#include "engine/face/seam_weld.h"
#include "engine/io/gltf_triangles.h"

namespace sinew {
namespace {

/// Seams close, lips that touch stay two (seam_weld.h).
void weld(const CharacterMesh& mesh, const Similarity& to_drawing, FaceMesh& out) {
  std::size_t places = 0;
  out.place_of = weld_seams(mesh.positions, mesh.triangles, places);
  out.positions.resize(places);
  for (std::size_t v = 0; v < mesh.vertices(); ++v)
    out.positions[out.place_of[v]] = to_drawing.point(mesh.positions[v]);
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
    const std::uint32_t a = out.place_of[mesh.triangles[i]], b = out.place_of[mesh.triangles[i + 1]],
                        c = out.place_of[mesh.triangles[i + 2]];
    if (a != b && b != c && c != a) out.triangles.insert(out.triangles.end(), {a, b, c});
  }
  out.normals = gltf::smooth_normals(out.positions, out.triangles);
}

class ShellSorter {
 public:
  ShellSorter(FaceMesh& mesh) : mesh_(mesh), places_(mesh.graph.shells) {
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) places_[mesh.graph.shell[v]].push_back(v);
    mesh_.kinds.assign(mesh.graph.shells, ShellKind::other);
    mesh_.eye_of_shell.assign(mesh.graph.shells, -1);
  }

  void find_skin() {
    // Any number of small pieces may lie about; the largest near the nose and the lips' corners is the skin.
    constexpr double near = 0.12;
    std::size_t best = 0;
    for (const char* mark : {"noseTip", "lipCornerLeft", "lipCornerRight"})
      for (std::size_t v = 0; v < mesh_.positions.size(); ++v) {
        const std::size_t shell = mesh_.graph.shell[v];
        if (places_[shell].size() > places_[best].size() || mesh_.kinds[best] != ShellKind::skin)
          if (glm::distance(mesh_.positions[v], mesh_.marks.at(mark)) < near) {
            mesh_.kinds[best] = ShellKind::other;
            mesh_.kinds[best = shell] = ShellKind::skin;
          }
      }
    for (std::size_t i = 0; i < mesh_.triangles.size(); i += 3)
      if (mesh_.kind(mesh_.triangles[i]) == ShellKind::skin)
        mesh_.skin_triangles.insert(mesh_.skin_triangles.end(),
                                    mesh_.triangles.begin() + static_cast<std::ptrdiff_t>(i),
                                    mesh_.triangles.begin() + static_cast<std::ptrdiff_t>(i + 3));
  }

  /// The ball of each eye, and what lies in and close to it.
  void find_eyes(double radius_share) {
    constexpr double most_error = 0.10, least_radius = 0.35, most_radius = 1.1;
    double radius_sum = 0.0;
    for (int side = 0; side < 2; ++side) {
      const std::string end = side == 0 ? "Left" : "Right";
      const Vec3 inner = mesh_.marks.at("eyeInner" + end), outer = mesh_.marks.at("eyeOuter" + end);
      const Vec3 middle = 0.5 * (inner + outer);
      const double width = glm::distance(inner, outer);
      FittedBall best;
      for (std::size_t s = 0; s < places_.size(); ++s) {
        if (mesh_.kinds[s] != ShellKind::other || places_[s].size() < 12) continue;
        const Bounds box = bounds(s);
        if (glm::distance(box.centre(), middle) > 1.1 * width || box.diagonal() > 4.0 * width) continue;
        const FittedBall ball = fitted_ball(points(s));
        // A film or a fringe before the eye fits a sphere as well, but is no ball.
        const Vec3 size = box.high - box.low;
        const bool round = std::min({size.x, size.y, size.z}) > ball.radius && ball.centre.z < middle.z;
        if (round && ball.error < std::min(most_error, best.error) && ball.radius > least_radius * width &&
            ball.radius < most_radius * width)
          best = ball;
      }
      const auto at = static_cast<std::size_t>(side);
      mesh_.has_eyeball[at] = best.radius > 0.0;
      // Without a ball: behind the middle of the eye, as far as in the template.
      mesh_.eye_centres[at] = best.radius > 0.0 ? best.centre : middle - Vec3(0, 0, 0.72 * radius_share * width);
      radius_sum += best.radius > 0.0 ? best.radius : radius_share * width;
      if (best.radius == 0.0) continue;
      for (std::size_t s = 0; s < places_.size(); ++s) {
        if (mesh_.kinds[s] != ShellKind::other) continue;
        const std::vector<Vec3> all = points(s);
        double farthest = 0.0;
        for (const Vec3& p : all) farthest = std::max(farthest, glm::distance(p, best.centre));
        const Vec3 forward = bounds(s).centre() - best.centre;
        const bool whole =
            farthest < 1.2 * best.radius && (fitted_ball(all).error < most_error || farthest < best.radius);
        if (!whole) continue;
        // A ring round the opening is no part of the ball.
        bool pole = glm::length(forward) < 0.5 * best.radius;
        for (const Vec3& p : all) pole = pole || angle_degrees(p - best.centre, Vec3(0, 0, 1)) < 14.0;
        if (!pole) continue;
        mesh_.kinds[s] = ShellKind::eyeball;
        mesh_.eye_of_shell[s] = side;
      }
    }
    mesh_.eye_radius = 0.5 * radius_sum;
  }

  void find_small_parts() {
    constexpr double largest = 1.7, touching = 0.10;
    const TriangleTree skin(mesh_.positions, mesh_.skin_triangles);
    const Vec3 lips = mesh_.marks.at("lipContact");
    const double mouth = glm::distance(mesh_.marks.at("lipCornerLeft"), mesh_.marks.at("lipCornerRight"));
    for (std::size_t s = 0; s < places_.size(); ++s) {
      if (mesh_.kinds[s] != ShellKind::other) continue;
      const Bounds box = bounds(s);
      const Vec3 c = box.centre();
      const bool inside = std::abs(c.x) < 0.7 * mouth && std::abs(c.y - lips.y) < 0.7 * mouth &&
                          box.high.z < lips.z + 0.02 && c.z > lips.z - 1.6 * mouth;
      if (inside && box.diagonal() < 3.0 * mouth) {
        mesh_.kinds[s] = c.y > lips.y ? ShellKind::upper : ShellKind::lower;
        continue;
      }
      if (box.diagonal() > largest || c.z < 0.2 || c.y < -0.1 || c.y > 2.7) continue;
      double farthest = 0.0;
      for (const Vec3& p : points(s)) {
        const auto near = skin.nearest(p, 0.5, [](std::size_t) { return true; });
        farthest = std::max(farthest, near ? near->distance : 1.0);
      }
      if (farthest < 2.0 * touching) mesh_.kinds[s] = ShellKind::attached;
    }
  }

 private:
  std::vector<Vec3> points(std::size_t shell) const {
    std::vector<Vec3> out;
    for (const std::uint32_t v : places_[shell]) out.push_back(mesh_.positions[v]);
    return out;
  }
  Bounds bounds(std::size_t shell) const {
    Bounds out;
    for (const std::uint32_t v : places_[shell]) out.add(mesh_.positions[v]);
    return out;
  }

  FaceMesh& mesh_;
  std::vector<std::vector<std::uint32_t>> places_;
};

/// Landmarks that both have, in one order.
struct Shared {
  std::vector<std::string> names;
  std::vector<Vec3> ours, theirs;
};
Shared shared_marks(const Landmarks& ours, const Landmarks& theirs) {
  Shared out;
  for (const auto& [name, place] : theirs)
    if (const auto found = ours.find(name); found != ours.end()) {
      out.names.push_back(name);
      out.ours.push_back(found->second);
      out.theirs.push_back(place);
    }
  return out;
}

Result<void> check_apart(const Landmarks& marks, double unit, const std::string& name) {
  for (const auto& [a, p] : marks)
    for (const auto& [b, q] : marks) {
      const auto is_lip = [](const std::string& s) {
        return s.find("Lip") != std::string::npos || s.starts_with("lip");
      };
      if (a < b && glm::distance(p, q) < 1e-3 * unit && !(is_lip(a) && is_lip(b)))
        return bad_input("{}: /landmarks/{}: at the same place as \"{}\"; expected different places", name, b, a);
    }
  return {};
}

}  // namespace

Result<FaceMesh> face_mesh(const CharacterMesh& mesh, const Landmarks& landmarks, const Landmarks& head_marks,
                           const std::string& name) {
  constexpr double far_off = 0.75;  // drawing units: wider than an eye
  const Shared shared = shared_marks(head_marks, landmarks);
  Bounds box;
  for (const Vec3& p : shared.theirs) box.add(p);
  if (auto ok = check_apart(landmarks, box.diagonal(), name); !ok) return pass_on(std::move(ok));
  Eigen::MatrixXd spread(3, shared.theirs.size());
  for (std::size_t i = 0; i < shared.theirs.size(); ++i)
    for (int c = 0; c < 3; ++c) spread(c, static_cast<Eigen::Index>(i)) = shared.theirs[i][c] - box.centre()[c];
  spread.colwise() -= spread.rowwise().mean().eval();
  const Eigen::Vector3d axes = spread.jacobiSvd().singularValues();
  if (!(axes(1) > 0.05 * axes(0)))
    return bad_input("{}: /landmarks: all lie on one line; expected places all over a face", name);

  FaceMesh out;
  out.to_mesh = best_similarity(shared.ours, shared.theirs);
  const Similarity to_drawing = out.to_mesh.inverse();
  for (std::size_t i = 0; i < shared.names.size(); ++i) {
    const double off = glm::distance(to_drawing.point(shared.theirs[i]), shared.ours[i]);
    if (off > far_off)
      return bad_input(
          "{}: /landmarks/{}: lies {:.2g} of the head's height from where the other landmarks have it; left and right "
          "are the character's own",
          name, shared.names[i], off / 3.5);
  }
  for (const auto& [mark, place] : landmarks) out.marks[mark] = to_drawing.point(place);
  if (!out.marks.contains("lipContact"))
    out.marks["lipContact"] = 0.5 * (out.marks.at("upperLip") + out.marks.at("lowerLip"));
  weld(mesh, to_drawing, out);
  out.graph = surface_graph(out.positions, out.triangles, false);
  ShellSorter sorter(out);
  sorter.find_skin();
  const double eye_width = glm::distance(head_marks.at("eyeInnerLeft"), head_marks.at("eyeOuterLeft"));
  constexpr double template_radius = 0.30;
  sorter.find_eyes(template_radius / eye_width);
  sorter.find_small_parts();

  // Left and right exchanged turn the similarity about: the skin then faces backwards.
  const TriangleTree skin(out.positions, out.skin_triangles);
  Vec3 facing(0.0);
  for (const char* mark : {"noseTip", "chin", "noseBase"})
    if (const auto near = skin.nearest(out.marks.at(mark), 1.0, [](std::size_t) { return true; }))
      for (int c = 0; c < 3; ++c)
        facing += near->shares[c] * out.normals[out.skin_triangles[3 * near->triangle + static_cast<std::size_t>(c)]];
  if (!(facing.z > 0.0))
    return bad_input(
        "{}: /landmarks: the skin faces backwards; are left and right exchanged? They are the character's own", name);
  return out;
}

Result<Landmarks> placed_landmarks(const CharacterMesh& mesh, const LandmarkPlaces& places, const std::string& name) {
  constexpr double far_off = 0.05;  // of the mesh
  if (mesh.triangles.empty()) return bad_input("{}: the model has no triangles, expected a mesh with a face", name);
  Bounds box;
  for (const Vec3& p : mesh.positions) box.add(p);
  Landmarks out;
  for (const auto& [mark, place] : places) {
    if (const auto* vertex = std::get_if<std::uint32_t>(&place)) {
      if (*vertex >= mesh.vertices())
        return bad_input("{}: /landmarks/{}: expected a vertex below {}, found {}", name, mark, mesh.vertices(),
                         *vertex);
      out[mark] = mesh.positions[*vertex];
      continue;
    }
    const Vec3& p = std::get<Vec3>(place);
    double nearest = INFINITY;
    for (const Vec3& q : mesh.positions) nearest = std::min(nearest, glm::distance(p, q));
    if (!(nearest < far_off * box.diagonal()))
      return bad_input("{}: /landmarks/{}: [{:.4g}, {:.4g}, {:.4g}] lies {:.3g} from the model's nearest vertex", name,
                       mark, p.x, p.y, p.z, nearest);
    out[mark] = p;
  }
  return out;
}

}  // namespace sinew
