#include "engine/body/figure_weights.h"

#include <algorithm>

#include "engine/body/figure_relax.h"
#include "engine/core/parallel.h"
#include "engine/fit/weight_run.h"

namespace sinew {
namespace {

constexpr std::size_t most_influences_kept = 4;
constexpr double least_share = 1e-3;

/// Rounds in which chains blend into each other over their borders.
constexpr int sharing_rounds = 6;
constexpr double most_fine_rounds = 60.0;

/// Where, along the arm, and in how many directions its thickness below the armpit is taken.
constexpr double radius_at = 0.06;
constexpr int radius_samples = 16;

/// Skin further than this from the arm's axis is no longer the arm's: at least so far, and so many times the arm's
/// thickness.
constexpr double least_reach = 0.052, reach_in_radii = 1.7;

/// 0 before a border, 1 behind it, over `half_width` to either side.
double behind(double x, double half_width) { return smoothstep01(0.5 * (x / half_width + 1.0)); }

/// Rounds of going half way to the neighbours' mean.
void blend(std::vector<ChainShares>& shares, const Neighbours& neighbours, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    const std::vector<ChainShares> before = shares;
    parallel_for(
        shares.size(),
        [&](std::size_t i) {
          ChainShares mean{};
          for (const Index n : neighbours.of(i))
            for (std::size_t chain = 0; chain < chain_count; ++chain) mean[chain] += before[n][chain];
          const double half = 0.5 / static_cast<double>(neighbours.of(i).size());
          for (std::size_t chain = 0; chain < chain_count; ++chain)
            shares[i][chain] = 0.5 * before[i][chain] + half * mean[chain];
        },
        256);
  }
}

}  // namespace

std::vector<ChainShares> chain_shares(const HalfCage& cage, const RefinedQuads& refined) {
  std::vector<ChainShares> on_cage(cage.vertices.size(), ChainShares{});
  for (std::size_t i = 0; i < on_cage.size(); ++i) on_cage[i][static_cast<std::size_t>(cage.vertices[i].chain)] = 1.0;
  blend(on_cage, Neighbours(cage.quads, cage.vertices.size()), sharing_rounds);

  std::vector<ChainShares> shares(refined.vertices.size(), ChainShares{});
  for (std::size_t i = 0; i < shares.size(); ++i)
    for (std::size_t chain = 0; chain < chain_count; ++chain)
      for (std::size_t c = 0; c < 4; ++c)
        shares[i][chain] += refined.vertices[i].weight[c] * on_cage[refined.vertices[i].corner[c]][chain];
  // As far as half a quad of the cage: a random walk goes that far in the square of its steps.
  const double parts = std::sqrt(static_cast<double>(refined.quads.size()) / static_cast<double>(cage.quads.size()));
  blend(shares, Neighbours(refined.quads, refined.vertices.size()),
        static_cast<int>(std::min(0.5 * parts * parts, most_fine_rounds)));
  return shares;
}

std::vector<FigureWeights::Step> FigureWeights::steps_present(std::span<const std::pair<const char*, double>> wanted,
                                                              std::span<const double> half_widths) const {
  std::vector<Step> steps;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (skeleton_.has(wanted[i].first)) steps.push_back({joint(wanted[i].first), wanted[i].second, half_widths[i]});
  return steps;
}

FigureWeights::FigureWeights(const MeasuredBody& body, const FigureSkeleton& skeleton)
    : body_(body), skeleton_(skeleton) {
  using Wanted = std::vector<std::pair<const char*, double>>;
  const auto y = [&](const char* name) { return skeleton.joints[static_cast<std::size_t>(joint(name))].position.y; };
  const bool full = skeleton.has("vl3");
  const double spine_width = full ? 0.030 : 0.045;
  spine_ = steps_present(Wanted{{"sacroiliac", 0.0},
                                {"vl5", y("vl5")},
                                {"vl3", y("vl3")},
                                {"vl1", y("vl1")},
                                {"vt10", y("vt10")},
                                {"vt6", y("vt6")},
                                {"vt1", y("vt1")},
                                {"vc4", y("vc4") + 0.004},
                                {"vc2", y("vc2")},
                                {"skullbase", y("skullbase")}},
                         std::vector<double>{0.0, spine_width, spine_width, spine_width, spine_width, spine_width,
                                             spine_width, 0.022, 0.018, 0.018});
  const BodyPart &arm = body.part("arm"), &leg = body.part("leg"), &foot = body.part("foot");
  for (int k = 0; k < radius_samples; ++k)
    arm_radius_ +=
        glm::distance(arm.on_surface(radius_at, 2.0 * std::numbers::pi * k / radius_samples), arm.on_axis(radius_at)) /
        radius_samples;
  const double elbow = arm.along(body.joint("lowerarm01")), wrist = arm.along(body.joint("wrist"));
  // Without a twist joint in the forearm its skin takes up the turn of the hand, over a longer way.
  const bool twists = skeleton.has("l_forearm_twist");
  const double hand_border = wrist - (twists ? 0.004 : 0.018), hand_width = twists ? 0.020 : 0.036;
  arm_ = steps_present(Wanted{{"l_shoulder", 0.0},
                              {"l_upperarm_twist", 0.5 * elbow},
                              {"l_elbow", elbow},
                              {"l_forearm_twist", 0.5 * (elbow + wrist)},
                              {"l_radiocarpal", hand_border}},
                       std::vector<double>{0.0, 0.040, 0.026, 0.040, hand_width});
  const double knee = leg.along(body.joint("lowerleg01")), ankle = leg.along(body.joint("foot"));
  leg_ = steps_present(Wanted{{"l_hip", 0.0}, {"l_knee", knee}, {"l_talocrural", ankle}},
                       std::vector<double>{0.0, 0.038, 0.022});
  foot_ =
      steps_present(Wanted{{"l_talocrural", 0.0},
                           {"l_tarsometatarsal", foot.along(glm::mix(body.joint("foot"), body.joint("toe2-1"), 0.5))},
                           {"l_metatarsophalangeal", foot.along(body.joint("toe2-1"))},
                           {"l_tarsal_interphalangeal", foot.along(body.joint("toe2-2"))}},
                    std::vector<double>{0.0, 0.020, 0.012, 0.006});
  for (int f = 1; f <= 5; ++f) {
    const std::string number = std::to_string(f);
    const BodyPart& tube = body.part("finger" + number);
    const std::array<std::string, 3> names =
        f == 1
            ? std::array<std::string, 3>{"l_carpometacarpal_1", "l_metacarpophalangeal_1", "l_carpal_interphalangeal_1"}
            : std::array<std::string, 3>{"l_metacarpophalangeal_" + number,
                                         "l_carpal_proximal_interphalangeal_" + number,
                                         "l_carpal_distal_interphalangeal_" + number};
    finger_[static_cast<std::size_t>(f - 1)] =
        steps_present(Wanted{{"l_radiocarpal", 0.0},
                             {names[0].c_str(), f == 1 ? 0.25 * tube.t_at(1) : 0.0},
                             {names[1].c_str(), tube.t_at(1)},
                             {names[2].c_str(), tube.t_at(2)}},
                      std::vector<double>{0.0, 0.010, 0.006, 0.0055});
  }
  clavicle_ = joint("l_sternoclavicular");
  acromion_ = joint("l_acromioclavicular");
  head_ = joint("skullbase");
  jaw_ = joint("temporomandibular");
  neck_ = joint("vc4");
}

namespace {

/// Adds what the steps' joints get at `t`.
template <class Steps>
void add_steps(const Steps& steps, double t, double share, std::vector<double>& weights) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double passed = i + 1 < steps.size() ? behind(t - steps[i + 1].border, steps[i + 1].half_width) : 0.0;
    weights[static_cast<std::size_t>(steps[i].joint)] += share * (1.0 - passed);
    share *= passed;
  }
}

}  // namespace

void FigureWeights::add_trunk(const Vec3& p, double share, Weights& weights) const {
  // The clavicle carries the top of the shoulder, as far as the neck leaves it.
  const double shoulder = body_.joint("upperarm01").y;
  const double neck = behind(p.y - body_.joint("neck01").y - 0.004, 0.022);
  const double clavicle = behind(p.x - 0.062, 0.036) * behind(p.y - (shoulder - 0.045), 0.035) * (1.0 - neck);
  const double outer = behind(p.x - 0.5 * (body_.joint("shoulder01").x + body_.joint("upperarm01").x), 0.03);
  weights[static_cast<std::size_t>(clavicle_)] += share * clavicle * (1.0 - outer);
  weights[static_cast<std::size_t>(acromion_)] += share * clavicle * outer;
  add_steps(spine_, p.y, share * (1.0 - clavicle), weights);
}

void FigureWeights::add_head(const Vec3& p, double share, Weights& weights) const {
  const Vec3& skull = body_.joint("head");
  // The jaw: below a line from the ear to the mouth, from the neck forward.
  const double jaw = jaw_ == head_ ? 0.0 : behind(skull.y - 0.006 - p.y, 0.012) * behind(p.z - skull.z - 0.028, 0.020);
  weights[static_cast<std::size_t>(jaw_)] += share * jaw;
  weights[static_cast<std::size_t>(head_)] += share * (1.0 - jaw);
}

double FigureWeights::arm_share(const Vec3& p) const {
  const BodyPart& arm = body_.part("arm");
  const double t = arm.along(p);
  const Vec3 out = p - arm.on_axis(t);
  // 1 on top of the shoulder, -1 in the armpit: above, the arm begins nearer to the neck.
  const double up = std::clamp(-glm::dot(unit_or(out, Vec3(0.0)), arm.v(0)), -1.0, 1.0);
  // The flank below the armpit lies beside the arm, not on it.
  const double on_arm = 1.0 - behind(glm::length(out) - std::max(least_reach, reach_in_radii * arm_radius_), 0.022);
  return behind(t - (0.006 - 0.020 * up), 0.056) * on_arm;
}

/// The trunk, and on top of the shoulder the arm: when it is raised, what lies between it and the neck goes with it by
/// degrees, or a notch would open there.
void FigureWeights::add_shoulder(const Vec3& p, double share, Weights& weights) const {
  const Vec3& shoulder = body_.joint("upperarm01");
  const double on_top = behind(p.y - (shoulder.y + 0.005), 0.025) * behind(p.x - 0.5 * shoulder.x, 0.4 * shoulder.x);
  const double arm = on_top * arm_share(p);
  add_trunk(p, share * (1.0 - arm), weights);
  weights[static_cast<std::size_t>(arm_.front().joint)] += share * arm;
}

void FigureWeights::add_arm(const Vec3& p, double share, Weights& weights) const {
  const double begun = arm_share(p);
  add_trunk(p, share * (1.0 - begun), weights);
  add_steps(arm_, body_.part("arm").along(p), share * begun, weights);
}

void FigureWeights::add_leg(const Vec3& p, double share, Weights& weights) const {
  const double t = body_.part("leg").along(p);
  // Between the legs the pelvis keeps the skin: there it would be torn between them.
  const double apart = glm::mix(smoothstep01(p.x / 0.035), 1.0, smoothstep01((t - 0.055) / 0.045));
  const double begun = behind(t - 0.035, 0.055) * apart;
  add_trunk(p, share * (1.0 - begun), weights);
  add_steps(leg_, t, share * begun, weights);
}

void FigureWeights::add_foot(const Vec3& p, double share, Weights& weights) const {
  add_steps(foot_, body_.part("foot").along(p), share, weights);
}

void FigureWeights::add_finger(int finger, const Vec3& p, double share, Weights& weights) const {
  add_steps(finger_[static_cast<std::size_t>(finger - 1)], body_.part("finger" + std::to_string(finger)).along(p),
            share, weights);
}

void FigureWeights::add_chain(Chain chain, const Vec3& position, double share, Weights& weights) const {
  if (is_finger(chain))
    return add_finger(static_cast<int>(chain) - static_cast<int>(Chain::finger1) + 1, position, share, weights);
  if (is_toe(chain) || chain == Chain::foot) return add_foot(position, share, weights);
  if (chain == Chain::leg) return add_leg(position, share, weights);
  if (chain == Chain::arm || chain == Chain::palm) return add_arm(position, share, weights);
  if (chain == Chain::head) return add_head(position, share, weights);
  add_shoulder(position, share, weights);
}

std::vector<Influence> FigureWeights::at(const Vec3& position, const ChainShares& shares, bool on_plane) const {
  Weights weights(skeleton_.joints.size(), 0.0);
  for (std::size_t chain = 0; chain < chain_count; ++chain)
    if (shares[chain] > 1e-6) add_chain(static_cast<Chain>(chain), position, shares[chain], weights);
  std::vector<Influence> run;
  for (std::size_t j = 0; j < weights.size(); ++j) {
    const bool middle = skeleton_.joints[j].mirror == static_cast<int>(j);
    if (weights[j] > least_share && (middle || !on_plane)) run.push_back({static_cast<std::uint32_t>(j), weights[j]});
  }
  return weight_run(std::move(run), most_influences_kept);
}

}  // namespace sinew
