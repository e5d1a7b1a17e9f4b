#include "engine/face/head_shapes.h"

#include <algorithm>
#include <cmath>

#include "engine/core/parallel.h"
#include "engine/face/expression.h"

namespace sinew {
namespace {

/// A shape before it is made.
struct Recipe {
  std::string name;
  FaceChannels from{}, to{};
  FaceHalf half = FaceHalf::both;
};

std::string channel_name(std::size_t i, bool positive) {
  const FaceChannelName& name = face_channel_names()[i];
  const std::string number = *name.number ? std::string(".") + name.number : "";
  return name.region + number + (positive ? "+" : "-");
}

std::vector<Recipe> recipes(const Head& head, bool strict) {
  std::vector<Recipe> out;
  for (std::size_t i = 0; i < face_channels; ++i)
    for (const bool positive : {true, false}) {
      FaceChannels far{};
      // Beyond any limit: held there, or at 0 where the channel cannot go that way alone.
      far[i] = positive ? 1e3 : -1e3;
      const FaceChannels held = hold_at_limits(head.face, far).channels;
      if (held[i] != 0.0) out.push_back({channel_name(i, positive), {}, held, FaceHalf::both});
    }
  for (const auto list : {expressions(), arkit_shapes()})
    for (const FacePreset& e : list) {
      const FaceChannels from = for_head(head.face, e.from);
      FaceChannels to = for_head(head.face, e.channels(strict));
      for (std::size_t i = 0; i < face_channels; ++i) to[i] += from[i];
      out.push_back({e.name, hold_at_limits(head.face, from).channels, hold_at_limits(head.face, to).channels, e.half});
    }
  return out;
}

/// The size of the eyeballs at which no lid that moves straight from rest to `posed` ever touches them.
double clear_eye_share(const Head& head, const std::vector<Vec3>& posed) {
  constexpr int steps = 20;
  constexpr double gap = 0.004;
  double share = 1.0;
  for (std::size_t v = 0; v < head.skin_vertices; ++v) {
    const FaceVertex& vertex = head.face.vertices[v];
    if (vertex.least_distance == 0.0 || posed[v] == head.positions[v]) continue;
    const Vec3& centre = head.face.eye_centres[static_cast<std::size_t>(vertex.eye)];
    for (int i = 1; i < steps; ++i) {
      const double t = double(i) / steps;
      const double distance = glm::distance(glm::mix(head.positions[v], posed[v], t), centre) - gap;
      // Of the ball's share 1 - t (1 - s).
      share = std::min(share, 1.0 - (1.0 - distance / head.face.eye_radius) / t);
    }
  }
  return share;
}

HeadShape made(const Head& head, const Recipe& recipe) {
  HeadShape out = posed_head(head, recipe.to);
  out.name = recipe.name;
  const double eye_share = clear_eye_share(head, out.positions);
  if (eye_share < 1.0)
    for (std::size_t v = 0; v < out.positions.size(); ++v)
      if (const FaceVertex& vertex = head.face.vertices[v]; vertex.ball) {
        const Vec3& centre = head.face.eye_centres[static_cast<std::size_t>(vertex.eye)];
        out.positions[v] = centre + eye_share * (out.positions[v] - centre);
      }
  if (recipe.from == FaceChannels{} && recipe.half == FaceHalf::both) return out;

  constexpr double blend_width = 0.15;
  const HeadShape from = posed_head(head, recipe.from);
  for (std::size_t v = 0; v < out.positions.size(); ++v) {
    const double to_left = smoothstep01(0.5 + 0.5 * head.positions[v].x / blend_width);
    const double part = recipe.half == FaceHalf::both ? 1.0 : (recipe.half == FaceHalf::left ? to_left : 1.0 - to_left);
    out.positions[v] = head.positions[v] + part * (out.positions[v] - from.positions[v]);
    out.normals[v] = head.normals[v] + part * (out.normals[v] - from.normals[v]);
  }
  return out;
}

}  // namespace

HeadShape posed_head(const Head& head, const FaceChannels& channels) {
  const FaceState state = face_state(head.face, channels);
  HeadShape out{"", head.positions, head.normals};
  FaceJob{head.face, state, head.positions, head.normals, out.positions, out.normals}.run();
  const std::vector<Vec3> of_surface = head_normals(head, out.positions);
  for (std::size_t v = 0; v < out.normals.size(); ++v) {
    // What only turns has turned normals already, exactly.
    const bool bends = v < head.skin_vertices || head.face.first[v + 1] > head.face.first[v];
    // Where nothing moves, nothing turns: the rest normals are symmetric to the bit, these sums are not.
    if (bends) out.normals[v] = glm::distance(of_surface[v], head.normals[v]) < 1e-9 ? head.normals[v] : of_surface[v];
  }
  return out;
}

std::vector<HeadShape> head_shapes(const Head& head, bool strict) {
  const std::vector<Recipe> all = recipes(head, strict);
  std::vector<HeadShape> out(all.size());
  parallel_for(
      all.size(), [&](std::size_t i) { out[i] = made(head, all[i]); }, 1);
  return out;
}

}  // namespace sinew
