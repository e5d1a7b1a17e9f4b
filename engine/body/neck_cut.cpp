#include "engine/body/neck_cut.h"

#include <algorithm>
#include <map>

#include "engine/fit/weight_run.h"

namespace sinew {
namespace {

constexpr std::size_t most_influences_kept = 4;

class Cutter {
 public:
  Cutter(const NeckPlane& plane, const Primitive& skin)
      : plane_(plane), skin_(skin), kept_(skin.positions.size(), none) {
    out_.material = skin.material;
  }

  void add_triangle(const std::array<std::uint32_t, 3>& corners) {
    std::array<bool, 3> above{};
    for (std::size_t c = 0; c < 3; ++c) above[c] = plane_.above(skin_.positions[corners[c]]) > 0.0;
    std::vector<std::uint32_t> polygon;
    BorderEdge edge{none, none};
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t next = (c + 1) % 3;
      if (!above[c]) polygon.push_back(kept(corners[c]));
      if (above[c] == above[next]) continue;
      polygon.push_back(above[c] ? crossing(corners[next], corners[c]) : crossing(corners[c], corners[next]));
      // Seen from outside, with what is kept below, the polygon runs along the cut from the left to the right side.
      (above[c] ? edge.from : edge.to) = polygon.back();
    }
    for (std::size_t i = 2; i < polygon.size(); ++i)
      out_.indices.insert(out_.indices.end(), {polygon[0], polygon[i - 1], polygon[i]});
    if (edge.from != none) border_.push_back(edge);
  }

  Primitive skin() { return std::move(out_); }
  std::vector<BorderEdge> border() { return std::move(border_); }

 private:
  static constexpr std::uint32_t none = ~0u;

  std::uint32_t kept(std::uint32_t vertex) {
    if (kept_[vertex] == none)
      kept_[vertex] = add(skin_.positions[vertex], skin_.normals[vertex], skin_.texture_coordinates[vertex],
                          influences_of(skin_.influences, vertex));
    return kept_[vertex];
  }

  /// Asked for from the kept end, so that both sides of the body get the same numbers.
  std::uint32_t crossing(std::uint32_t below, std::uint32_t above) {
    const auto [place, is_new] = crossings_.try_emplace({below, above}, none);
    if (!is_new) return place->second;
    const Vec3 &a = skin_.positions[below], &b = skin_.positions[above];
    const double t = plane_.above(a) / (plane_.above(a) - plane_.above(b));
    const auto run =
        mixed_influences(influences_of(skin_.influences, below), influences_of(skin_.influences, above), t);
    place->second =
        add(glm::mix(a, b, t), unit_or(glm::mix(skin_.normals[below], skin_.normals[above], t), skin_.normals[below]),
            glm::mix(skin_.texture_coordinates[below], skin_.texture_coordinates[above], t), run);
    return place->second;
  }

  std::uint32_t add(const Vec3& position, const Vec3& normal, const Vec2& uv, std::span<const Influence> run) {
    out_.positions.push_back(position);
    out_.normals.push_back(normal);
    out_.texture_coordinates.push_back(uv);
    out_.influences.add_vertex({run.begin(), run.end()});
    return static_cast<std::uint32_t>(out_.positions.size() - 1);
  }

  const NeckPlane& plane_;
  const Primitive& skin_;
  Primitive out_;
  std::vector<std::uint32_t> kept_;  ///< [vertices] their new numbers
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
  std::vector<BorderEdge> border_;
};

}  // namespace

std::vector<BorderEdge> cut_above(const NeckPlane& plane, Primitive& skin) {
  Cutter cutter(plane, skin);
  for (std::size_t i = 0; i < skin.indices.size(); i += 3)
    cutter.add_triangle({skin.indices[i], skin.indices[i + 1], skin.indices[i + 2]});
  skin = cutter.skin();
  return cutter.border();
}

std::vector<Influence> mixed_influences(std::span<const Influence> one, std::span<const Influence> other,
                                        double share) {
  Mixture mixture;
  mixture.add(one, 1.0 - share);
  mixture.add(other, share);
  return weight_run(mixture.list(), most_influences_kept);
}

}  // namespace sinew
