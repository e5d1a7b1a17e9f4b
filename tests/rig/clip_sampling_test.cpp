#include "engine/rig/clip_sampling.h"

#include <functional>

#include <gtest/gtest.h>

namespace sinew {
namespace {

/// Roundings of a dozen sums and products of numbers of size one.
constexpr double rounding = 1e-13;

const std::vector<double> key_times = {0.25, 0.5, 1.25, 3.0};  // not evenly apart: tangents are per second

Pose blank_pose() {
  Pose pose;
  pose.local.resize(2);
  pose.local[0] = {{7, 8, 9}, rotation_xyz_degrees({5, 6, 7}), {2, 3, 4}};
  pose.local[1] = pose.local[0];
  pose.morph_weights = {{0.5, 0.25}, {0.125}};
  return pose;
}

Pose sampled(const Channel& channel, double seconds) {
  Pose pose = blank_pose();
  sample_clip({"", {channel}, channel.times.back()}, seconds, pose);
  return pose;
}

/// A function of time and its derivative, a number for each component.
struct Motion {
  std::function<Vec3(double)> place, speed;
};

/// A polynomial of the third degree in each component.
const Motion cubic{[](double t) { return Vec3(1 + t * (2 + t * (-3 + t)), t * t * t, 0.5 - t); },
                   [](double t) { return Vec3(2 + t * (-6 + 3 * t), 3 * t * t, -1); }};

Channel channel_of(const Motion& motion, ChannelPath path, Interpolation interpolation) {
  Channel channel{0, path, interpolation, 3, key_times, {}};
  for (const double t : key_times) {
    const Vec3 place = motion.place(t), speed = motion.speed(t);
    for (const Vec3& v : interpolation == Interpolation::cubic_spline ? std::vector<Vec3>{speed, place, speed}
                                                                      : std::vector<Vec3>{place})
      channel.values.insert(channel.values.end(), {v.x, v.y, v.z});
  }
  return channel;
}

Channel rotation_channel(const std::vector<Quat>& keys, Interpolation interpolation) {
  Channel channel{0, ChannelPath::rotation, interpolation, 4, {}, {}};
  const std::vector<double> level(4, 0.0);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    channel.times.push_back(key_times[i]);
    const bool cubic_keys = interpolation == Interpolation::cubic_spline;
    if (cubic_keys) channel.values.insert(channel.values.end(), level.begin(), level.end());
    channel.values.insert(channel.values.end(), {keys[i].x, keys[i].y, keys[i].z, keys[i].w});
    if (cubic_keys) channel.values.insert(channel.values.end(), level.begin(), level.end());
  }
  return channel;
}

TEST(ClipSampling, ACubicSplineReproducesCubicsExactly) {
  const Channel channel = channel_of(cubic, ChannelPath::translation, Interpolation::cubic_spline);
  for (double t = 0.25; t <= 3.0; t += 0.01)
    EXPECT_LT(glm::length(sampled(channel, t).local[0].translation - cubic.place(t)), rounding) << t;
}

TEST(ClipSampling, ACubicSplineIsTheSpecificationsHermiteForm) {
  // glTF 2.0, appendix C.5, with a jump of the speed at the key in the middle: out-tangent and in-tangent differ.
  Channel channel{0, ChannelPath::scale, Interpolation::cubic_spline, 3, {1.0, 3.0, 4.0}, {}};
  for (int i = 0; i < 27; ++i) channel.values.push_back(std::sin(3.0 * i));
  const auto at = [&](std::size_t key, std::size_t row, std::size_t k) {
    return channel.values[(key * 3 + row) * 3 + k];
  };
  for (const double t : {1.2, 2.0, 2.9, 3.1, 3.75}) {
    const std::size_t k = t < 3.0 ? 0 : 1;
    const double duration = channel.times[k + 1] - channel.times[k], u = (t - channel.times[k]) / duration;
    for (std::size_t i = 0; i < 3; ++i) {
      const double expected = (2 * std::pow(u, 3) - 3 * std::pow(u, 2) + 1) * at(k, 1, i) +
                              duration * (std::pow(u, 3) - 2 * std::pow(u, 2) + u) * at(k, 2, i) +
                              (-2 * std::pow(u, 3) + 3 * std::pow(u, 2)) * at(k + 1, 1, i) +
                              duration * (std::pow(u, 3) - std::pow(u, 2)) * at(k + 1, 0, i);
      EXPECT_NEAR(sampled(channel, t).local[0].scale[static_cast<int>(i)], expected, rounding);
    }
  }
}

TEST(ClipSampling, LinearKeysReproduceStraightLinesAndMeetAtTheKeys) {
  const Motion line{[](double t) { return Vec3(1 + 2 * t, -t, 3); }, [](double) { return Vec3(0); }};
  const Channel straight = channel_of(line, ChannelPath::scale, Interpolation::linear);
  const Channel bent = channel_of(cubic, ChannelPath::translation, Interpolation::linear);
  for (double t = 0.25; t < 3.0; t += 0.01)
    EXPECT_LT(glm::length(sampled(straight, t).local[0].scale - line.place(t)), rounding);
  EXPECT_LT(glm::length(sampled(bent, 2.125).local[0].translation - 0.5 * (cubic.place(1.25) + cubic.place(3.0))),
            rounding);
}

TEST(ClipSampling, AStepHoldsUntilTheNextKey) {
  const Channel channel = channel_of(cubic, ChannelPath::translation, Interpolation::step);
  for (const auto& [t, key] :
       {std::pair(0.25, 0.25), {0.4999999, 0.25}, {0.5, 0.5}, {1.0, 0.5}, {2.9, 1.25}, {3.0, 3.0}})
    EXPECT_EQ(sampled(channel, t).local[0].translation, cubic.place(key)) << t;
}

TEST(ClipSampling, EveryKeyIsReachedExactlyAndTheEndsAreHeld) {
  for (const Interpolation interpolation : {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline}) {
    const Channel channel = channel_of(cubic, ChannelPath::translation, interpolation);
    for (const double t : key_times) EXPECT_EQ(sampled(channel, t).local[0].translation, cubic.place(t));
    EXPECT_EQ(sampled(channel, -5.0).local[0].translation, cubic.place(0.25));
    EXPECT_EQ(sampled(channel, 0.0).local[0].translation, cubic.place(0.25));
    EXPECT_EQ(sampled(channel, 99.0).local[0].translation, cubic.place(3.0));
  }
}

TEST(ClipSampling, OneKeyIsAConstant) {
  for (const Interpolation interpolation : {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline}) {
    const bool is_cubic = interpolation == Interpolation::cubic_spline;
    const Channel channel{0,
                          ChannelPath::translation,
                          interpolation,
                          3,
                          {1.0},
                          is_cubic ? std::vector<double>{9, 9, 9, 1, 2, 3, 9, 9, 9} : std::vector<double>{1, 2, 3}};
    for (const double t : {0.0, 1.0, 2.0}) EXPECT_EQ(sampled(channel, t).local[0].translation, Vec3(1, 2, 3));
  }
}

TEST(ClipSampling, LinearRotationsTurnEvenlyAboutOneAxis) {
  const Vec3 axis = glm::normalize(Vec3(1, 2, -3));
  const auto turned = [&](double degrees) { return glm::angleAxis(degrees * degrees_to_radians, axis); };
  const Channel channel = rotation_channel({turned(10), turned(130), turned(20)}, Interpolation::linear);
  for (double u = 0.0; u <= 1.0; u += 0.05) {
    const Quat first = sampled(channel, 0.25 + 0.25 * u).local[0].rotation;
    const Quat second = sampled(channel, 0.5 + 0.75 * u).local[0].rotation;
    EXPECT_NEAR(std::abs(glm::dot(first, turned(10 + 120 * u))), 1.0, rounding);
    EXPECT_NEAR(std::abs(glm::dot(second, turned(130 - 110 * u))), 1.0, rounding);
  }
}

TEST(ClipSampling, RotationsTakeTheShorterWayRound) {
  // The same turn is written as q and as -q: a file may hold either.
  const Quat from = glm::angleAxis(10 * degrees_to_radians, Vec3(0, 1, 0));
  const Quat to = -glm::angleAxis(50 * degrees_to_radians, Vec3(0, 1, 0));
  const Quat middle = glm::angleAxis(30 * degrees_to_radians, Vec3(0, 1, 0));
  const Channel channel = rotation_channel({from, to}, Interpolation::linear);
  EXPECT_NEAR(std::abs(glm::dot(sampled(channel, 0.375).local[0].rotation, middle)), 1.0, rounding);
}

TEST(ClipSampling, RotationsAreUnitLengthAndInTheFilesOrder) {
  const Channel stored{0, ChannelPath::rotation, Interpolation::step, 4, {0.0}, {0, 0, 3, 4}};  // x, y, z, w
  EXPECT_LT(glm::length(sampled(stored, 0).local[0].rotation - Quat(0.8, 0, 0, 0.6)), rounding);
  const Quat a(0.6, 0.8, 0, 0), b(0.6, 0, 0.8, 0);
  for (const Interpolation interpolation : {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline})
    for (double t = 0.2; t < 0.6; t += 0.03)
      EXPECT_NEAR(glm::length(sampled(rotation_channel({2.0 * a, b}, interpolation), t).local[0].rotation), 1.0,
                  rounding);
  // With level tangents the middle of a spline is the mean of both keys, then of unit length.
  const Quat middle = sampled(rotation_channel({a, b}, Interpolation::cubic_spline), 0.375).local[0].rotation;
  EXPECT_LT(glm::length(middle - glm::normalize(a + b)), rounding);
}

TEST(ClipSampling, WritesOnlyWhatTheClipAnimates) {
  const Pose before = blank_pose();
  const Channel channel = channel_of(cubic, ChannelPath::translation, Interpolation::linear);
  const Pose after = sampled(channel, 1.0);
  EXPECT_NE(after.local[0].translation, before.local[0].translation);
  EXPECT_EQ(after.local[0].rotation, before.local[0].rotation);
  EXPECT_EQ(after.local[0].scale, before.local[0].scale);
  EXPECT_EQ(after.local[1].translation, before.local[1].translation);
  EXPECT_EQ(after.morph_weights, before.morph_weights);
  Pose untouched = blank_pose();
  sample_clip({}, 1.0, untouched);
  EXPECT_EQ(untouched.local[0].translation, before.local[0].translation);
}

TEST(ClipSampling, MorphWeightsAreAsWideAsTheTargets) {
  const Channel channel{0, ChannelPath::weights, Interpolation::linear, 2, {0.0, 2.0}, {0, 1, 1, -1}};
  Pose pose = sampled(channel, 0.5);
  EXPECT_EQ(pose.morph_weights[0], (std::vector<double>{0.25, 0.5}));
  EXPECT_EQ(pose.morph_weights[1], (std::vector<double>{0.125}));
  const Channel smooth{0, ChannelPath::weights, Interpolation::cubic_spline, 1, {0.0, 2.0}, {0, 0, 1, 1, 2, 0}};
  EXPECT_EQ(sampled(smooth, 1.0).morph_weights[0], (std::vector<double>{1.0}));  // the straight line, 1 a second
}

TEST(ClipSampling, SeveralChannelsGoToTheirNodes) {
  Channel one = channel_of(cubic, ChannelPath::translation, Interpolation::step), other = one;
  other.node = 1;
  other.path = ChannelPath::scale;
  Pose pose = blank_pose();
  sample_clip({"", {one, other}, 3.0}, 0.5, pose);
  EXPECT_EQ(pose.local[0].translation, cubic.place(0.5));
  EXPECT_EQ(pose.local[1].scale, cubic.place(0.5));
  EXPECT_EQ(pose.local[1].translation, Vec3(7, 8, 9));
}

}  // namespace
}  // namespace sinew
