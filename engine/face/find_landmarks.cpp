#include "engine/face/find_landmarks.h"

#include <algorithm>
#include <optional>

#include "engine/face/body_head.h"
#include "engine/face/face_transfer.h"
#include "engine/face/head_profile.h"
#include "engine/face/seam_weld.h"
#include "engine/face/visible_eye.h"

namespace sinew {
namespace {

/// The head's largest piece, in its own axes, so that it can be looked at from the front.
struct FrontView {
  std::vector<Vec3> positions;  ///< [vertices] x left, y up, z front
  std::vector<std::uint32_t> skin, rest;
};

FrontView front_view(const CharacterMesh& mesh, const HeadSite& site) {
  FrontView out;
  const Mat3 to_own = glm::transpose(site.axes);
  for (const Vec3& p : mesh.positions) out.positions.push_back(to_own * p);
  // Eyes that lie on the lids' edge are no part of the skin.
  std::size_t places = 0;
  const std::vector<std::uint32_t> place_of = weld_seams(mesh.positions, mesh.triangles, places);
  std::vector<Vec3> at(places);
  std::vector<std::uint32_t> triangles;
  for (std::size_t v = 0; v < mesh.vertices(); ++v) at[place_of[v]] = mesh.positions[v];
  for (const std::uint32_t v : mesh.triangles) triangles.push_back(place_of[v]);
  const SurfaceGraph graph = surface_graph(at, triangles, false);
  const auto shell = [&](std::size_t v) { return graph.shell[place_of[v]]; };
  std::vector<bool> inside = site.inside.empty() ? std::vector<bool>(mesh.vertices(), true) : site.inside;
  std::vector<std::size_t> size(graph.shells, 0);
  for (std::size_t v = 0; v < mesh.vertices(); ++v)
    if (inside[v]) ++size[shell(v)];
  const auto largest = static_cast<std::uint32_t>(std::ranges::max_element(size) - size.begin());
  const auto gather = [&](bool of_largest) {
    std::vector<std::uint32_t> gathered;
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
      const std::uint32_t* t = &mesh.triangles[i];
      if (inside[t[0]] && inside[t[1]] && inside[t[2]] && (shell(t[0]) == largest) == of_largest)
        gathered.insert(gathered.end(), t, t + 3);
    }
    return gathered;
  };
  if (site.inside.empty()) inside = above_neck(out.positions, gather(true));
  out.skin = gather(true);
  out.rest = gather(false);
  return out;
}

}  // namespace

Result<FoundLandmarks> find_landmarks(const CharacterMesh& mesh, const HeadSite& site, const std::string& name) {
  const FrontView view = front_view(mesh, site);
  const TriangleTree skin(view.positions, view.skin);
  const auto profile = find_profile(view.positions, view.skin, skin);
  if (!profile) return bad_input("{}: no head with a profile was found; expected landmarks in a file", name);
  FoundLandmarks out;
  const Head& head = template_head();
  const double unit = (profile->crown.y - profile->chin.y) / head_units;
  // By proportion, on the surface as the front shows it.
  const auto on_surface = [&](double x, double y) -> std::optional<Vec3> {
    const double far = profile->nose_tip.z + unit;
    const auto hit = skin.first_crossing({x, y, far}, {0, 0, -1}, 4 * unit);
    if (!hit) return {};
    return Vec3(x, y, far - *hit);
  };
  const auto proportional = [&](const std::string& mark) {
    const Vec3& p = head.positions[head.marks.at(mark)];
    const auto found = on_surface(profile->middle + unit * p.x, profile->chin.y + unit * p.y);
    if (found) out.marks[mark] = *found;
  };
  for (const char* mark : {"eyeInnerLeft", "eyeInnerRight", "eyeOuterLeft", "eyeOuterRight", "lipCornerLeft",
                           "lipCornerRight", "noseBase", "lipContact", "noseTip"})
    proportional(mark);
  out.marks["chin"] = profile->chin;
  // A nose alone, on a head without lips, is no measure for where the lips would be.
  if (profile->has_lips) {
    out.marks["noseTip"] = profile->nose_tip;
    out.marks["noseBase"] = profile->nose_base;
  }
  if (profile->has_lips) out.marks["lipContact"] = profile->lip_contact;

  const auto eyes = find_visible_eyes(view.positions, view.rest, skin, profile->middle, profile->nose_tip, unit);
  for (const auto& [mark, place] : eyes) out.marks[mark] = place;
  if (profile->has_lips) {
    const double reach = eyes.empty() ? 0.40 * unit
                                      : 0.40 / 0.72 * 0.5 *
                                            (0.5 * (out.marks["eyeInnerLeft"].x + out.marks["eyeOuterLeft"].x) -
                                             0.5 * (out.marks["eyeInnerRight"].x + out.marks["eyeOuterRight"].x));
    for (const int side : {1, -1})
      if (const auto corner = find_lip_corner(skin, *profile, side, reach, unit))
        out.marks[side > 0 ? "lipCornerLeft" : "lipCornerRight"] = *corner;
  }
  out.notes.push_back(fmt::format(
      "landmarks were found: nose {}, lips {}, eyes {}", profile->has_lips ? "by its profile" : "by proportion",
      profile->has_lips ? "by their profile" : "by proportion", eyes.empty() ? "by proportion" : "by their balls"));
  out.by_features = profile->has_lips || !eyes.empty();
  for (const LandmarkName& l : landmark_names())
    if (l.required && !out.marks.contains(l.name))
      return bad_input("{}: a head was found, but no \"{}\" on it; expected landmarks in a file", name, l.name);
  if (!out.marks.contains("lipContact"))
    return bad_input("{}: a head was found, but no \"lipContact\" on it; expected landmarks in a file", name);
  for (auto& [mark, place] : out.marks) place = site.axes * place;
  return out;
}

}  // namespace sinew
