#include "engine/face/region_moves.h"

#include <algorithm>
#include <functional>

#include "engine/face/head_cage_parts.h"

namespace sinew {
namespace {

using Moves = std::vector<Vec3>;  ///< [half cage] at signal 1

/// Moves of one signal on every vertex of the skin.
struct SkinMoves {
  std::size_t signal;
  std::vector<Vec3> moves;
};

class MoveCarrier {
 public:
  MoveCarrier(const HeadTopology& topology, std::size_t cage_points) : topology_(topology), cage_points_(cage_points) {}

  using Rule = std::function<Vec3(std::size_t)>;  ///< a cage point's move

  /// A move of the left side, and its mirror image of the right.
  void side(FaceSignal signal, const Rule& rule) {
    const Moves moves = by(rule);
    std::vector<Vec3> left(topology_.vertices()), right = left;
    for (int c = 0; c < 3; ++c) {
      const std::vector<double> values = topology_.left_values(component(moves, c));
      for (std::size_t v = 0; v < values.size(); ++v) left[v][c] = values[v];
    }
    for (std::size_t v = 0; v < left.size(); ++v) {
      const Vec3& m = left[topology_.mirror()[v]];
      right[v] = {-m.x, m.y, m.z};
    }
    all_.push_back({signal_index(signal, 0), std::move(left)});
    all_.push_back({signal_index(signal, 1), std::move(right)});
  }
  /// A move of both halves alike; points of the mid line have no x of their own.
  void middle(FaceMiddleSignal signal, const Rule& rule) {
    const Moves moves = by(rule);
    std::vector<Vec3> out(topology_.vertices());
    const std::vector<double> x = topology_.left_values(component(moves, 0));
    for (std::size_t v = 0; v < out.size(); ++v) out[v].x = x[v] - x[topology_.mirror()[v]];
    for (int c = 1; c < 3; ++c) {
      const std::vector<double> values = topology_.even_values(component(moves, c));
      for (std::size_t v = 0; v < values.size(); ++v) out[v][c] = values[v];
    }
    all_.push_back({signal_index(signal), std::move(out)});
  }
  const std::vector<SkinMoves>& all() const { return all_; }

 private:
  Moves by(const Rule& rule) const {
    Moves out(cage_points_);
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = rule(v);
    return out;
  }
  static CageValues component(const Moves& moves, int c) {
    CageValues out(moves.size());
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = moves[v][c];
    return out;
  }

  const HeadTopology& topology_;
  std::size_t cage_points_;
  std::vector<SkinMoves> all_;
};

void add_brow_moves(const HeadCage& cage, const FaceRig& face, MoveCarrier& carry) {
  const CageValues w = region_weights(cage, "brow");
  // Sideways a brow stays on the forehead; upwards the forehead leans back; inwards it bunches.
  carry.side(FaceSignal::brow_out, [&](std::size_t v) { return w[v] * Vec3(1.0, 0.0, -0.15); });
  carry.side(FaceSignal::brow_in, [&](std::size_t v) { return w[v] * Vec3(-1.0, 0.0, 0.20); });
  carry.side(FaceSignal::brow_up, [&](std::size_t v) { return w[v] * Vec3(0.0, 1.0, -0.25); });
  carry.side(FaceSignal::brow_down, [&](std::size_t v) { return w[v] * Vec3(0.0, -1.0, 0.10); });
  carry.side(FaceSignal::brow_turn_inner, [&](std::size_t v) {
    return w[v] * std::max(0.0, face.brow_outer - cage.positions[v].x) * Vec3(0.0, 1.0, -0.20);
  });
  carry.side(FaceSignal::brow_turn_outer, [&](std::size_t v) {
    return w[v] * std::max(0.0, cage.positions[v].x - face.brow_inner) * Vec3(0.0, 1.0, -0.20);
  });
}

void add_mouth_moves(const HeadPlan& plan, const HeadCage& cage, MoveCarrier& carry) {
  const CageValues upper = region_weights(cage, "upper_lip"), lower = region_weights(cage, "lower_lip"),
                   corner = region_weights(cage, "corner");
  carry.middle(FaceMiddleSignal::upper_lip_up, [&](std::size_t v) { return upper[v] * Vec3(0.0, 1.0, 0.12); });
  carry.middle(FaceMiddleSignal::lower_lip_up, [&](std::size_t v) { return lower[v] * Vec3(0.0, 1.0, 0.06); });
  carry.middle(FaceMiddleSignal::lower_lip_down, [&](std::size_t v) { return lower[v] * Vec3(0.0, -1.0, 0.10); });
  // The corner follows the face: straight sideways it would tear off the cheek.
  carry.side(FaceSignal::corner_out, [&](std::size_t v) { return corner[v] * Vec3(1.0, 0.0, -1.05); });
  carry.side(FaceSignal::corner_in, [&](std::size_t v) { return corner[v] * Vec3(-1.0, 0.0, 0.70); });
  carry.side(FaceSignal::corner_up, [&](std::size_t v) { return corner[v] * Vec3(0.0, 1.0, -0.10); });
  carry.side(FaceSignal::corner_down, [&](std::size_t v) { return corner[v] * Vec3(0.0, -1.0, 0.0); });

  const double k = plan.mouth_scale, mw = plan.m.mouth_width;
  const auto is_mouth = [&](std::size_t v) { return cage.names[v].part == HeadPart::mouth; };
  carry.middle(FaceMiddleSignal::pucker, [&, k, mw](std::size_t v) {
    const Vec3& p = cage.positions[v];
    if (!is_mouth(v)) return Vec3(0.0);
    constexpr double narrow[] = {0.30, 0.46, 0.46, 0.46, 0.46, 0.34, 0.14},
                     forth[] = {0.3, 0.9, 1.0, 1.0, 0.95, 0.5, 0.1};
    const int ring = cage.names[v].ring;
    const double depth = glm::mix(plan.lip_line, plan.corner, std::pow(std::min(1.0, p.x / mw), 2));
    const double x = p.x * (1.0 - narrow[ring]);
    const double depth_there = glm::mix(plan.lip_line, plan.corner, std::pow(std::min(1.0, x / mw), 2));
    const double away = std::clamp((p.y - plan.mouth) / (0.12 * k), -1.0, 1.0);
    const bool lip = ring == 3 || ring == 4;
    return Vec3(x - p.x, lip ? 0.018 * k * away : 0.0,
                narrow[ring] / 0.46 * (depth_there - depth) + 0.11 * k * forth[ring]);
  });
  carry.middle(FaceMiddleSignal::press, [&, k](std::size_t v) {
    if (!is_mouth(v)) return Vec3(0.0);
    constexpr double thin[] = {0.0, 0.0, 0.0, 0.55, 0.50, 0.12, 0.0},
                     back[] = {0.0, 0.02, 0.02, 0.045, 0.015, 0.0, 0.0};
    const int ring = cage.names[v].ring;
    return Vec3(0.0, thin[ring] * (plan.mouth - cage.positions[v].y) * (ring == 5 ? 0.5 : 1.0), -back[ring] * k);
  });
}

void add_helper_moves(const HeadPlan& plan, const HeadCage& cage, MoveCarrier& carry) {
  const double x = 1.16 * plan.m.eye_spacing, y = glm::mix(plan.nose, plan.eye, 0.22);
  carry.side(FaceSignal::cheek_up, [&, x, y](std::size_t v) {
    const CagePoint& name = cage.names[v];
    const Vec3& p = cage.positions[v];
    const bool takes_part = name.part == HeadPart::cheek || (name.part == HeadPart::eye && name.ring >= 5) ||
                            (name.part == HeadPart::nose && name.ring == 3) ||
                            (name.part == HeadPart::mouth && name.ring == 6) ||
                            (name.part == HeadPart::side && name.ring == 0);
    if (!takes_part || p.y >= plan.eye - 0.1) return Vec3(0.0);
    const double across = (p.x - x) / 0.24, up = (p.y - y) / 0.17, w = std::exp(-across * across - up * up);
    return w > 0.02 ? w * Vec3(0.0, 1.0, 0.55) : Vec3(0.0);
  });
  const CageValues w = region_weights(cage, "nose");
  carry.middle(FaceMiddleSignal::nose, [&](std::size_t v) {
    const CagePoint& name = cage.names[v];
    const bool wing = name.part == HeadPart::nose && (name.ring == 2 || name.ring == 3);
    Vec3 move = w[v] * Vec3(wing ? 0.25 : 0.0, 1.0, 0.15);
    // The root folds: out, in, out down the ridge.
    constexpr double fold[] = {0.10, -0.22, 0.25, -0.12};
    if (name.part == HeadPart::nose && name.ring < 2 && name.place < 4)
      move.z += fold[name.place] * (name.ring ? 0.8 : 1.0);
    if (name.part == HeadPart::nose && name.ring == 0) move.x = 0.0;
    return move;
  });
}

}  // namespace

CageValues jaw_weights(const HeadPlan& plan, const HeadCage& cage, bool sealed) {
  CageValues out = region_weights(cage, sealed ? "jaw_sealed" : "jaw");
  const double high = plan.nose + 0.02, low = 0.52 * plan.mouth, hinge = plan.m.ear_bottom + 0.12;
  for (std::size_t v = 0; v < out.size(); ++v) {
    const CagePoint& name = cage.names[v];
    const double y = cage.positions[v].y;
    const bool side = name.part == HeadPart::side;
    if (name.part == HeadPart::cheek || (side && name.ring <= 1 && y < high))
      out[v] = std::pow(smoothstep01((high - y) / (high - low)), 1.1) * (side && name.ring == 1 ? 0.85 : 1.0);
    if (side && name.ring == 2 && y < hinge - 0.2) out[v] = 0.55 * smoothstep01((hinge - 0.2 - y) / 0.4);
  }
  return out;
}

void add_region_moves(const HeadPlan& plan, const HeadTopology& topology, const HeadCage& cage,
                      const std::vector<Vec3>& skin, FaceRig& face) {
  constexpr double nothing = 1e-7;
  MoveCarrier carry(topology, cage.positions.size());
  add_brow_moves(cage, face, carry);
  add_mouth_moves(plan, cage, carry);
  add_helper_moves(plan, cage, carry);
  std::vector<const SkinMoves*> order;
  for (const SkinMoves& moves : carry.all()) order.push_back(&moves);
  std::ranges::sort(order, {}, &SkinMoves::signal);
  face.first.assign(1, 0);
  face.deltas.clear();
  for (std::size_t v = 0; v < skin.size(); ++v) {
    for (const SkinMoves* moves : order)
      if (glm::length(moves->moves[v]) > nothing)
        face.deltas.push_back({static_cast<std::uint32_t>(moves->signal), moves->moves[v], Vec3(0.0)});
    face.first.push_back(static_cast<std::uint32_t>(face.deltas.size()));
  }
}

}  // namespace sinew
