#include "engine/motion/library_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include <nlohmann/json.hpp>

#include "engine/motion/smooth_basis.h"

namespace sinew {
namespace {

static_assert(std::endian::native == std::endian::little, "the library's numbers are little-endian");

using Json = nlohmann::ordered_json;

void append(Bytes& bytes, double number) {
  const auto* raw = reinterpret_cast<const unsigned char*>(&number);
  bytes.insert(bytes.end(), raw, raw + sizeof number);
}

void append(Bytes& bytes, const Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) append(bytes, v[axis]);
}

std::vector<double> numbers_of(std::span<const unsigned char> bytes) {
  std::vector<double> numbers(bytes.size() / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
  return numbers;
}

Json json_of(const Vec3& v) { return {v.x, v.y, v.z}; }

Vec3 vec3_of(const Json& json) { return {json.at(0), json.at(1), json.at(2)}; }

MotionJoint joint_of(const Json& json) {
  MotionJoint joint;
  joint.name = json.at("name");
  joint.parent = json.at("parent");
  joint.offset = vec3_of(json.at("offset"));
  const Json& rest = json.at("rest_rotation");
  joint.rest_rotation = Quat(rest.at(0), rest.at(1), rest.at(2), rest.at(3));
  for (const int channel : json.at("channels")) joint.channels.push_back(static_cast<MotionChannel>(channel));
  if (json.contains("end")) joint.end = vec3_of(json.at("end"));
  return joint;
}

}  // namespace

std::string skeleton_text(const MotionSkeleton& skeleton) {
  Json joints = Json::array();
  for (const MotionJoint& joint : skeleton.joints) {
    const Quat& q = joint.rest_rotation;
    Json channels = Json::array();
    for (const MotionChannel channel : joint.channels) channels.push_back(static_cast<int>(channel));
    Json json{{"name", joint.name},
              {"parent", joint.parent},
              {"offset", json_of(joint.offset)},
              {"rest_rotation", {q.w, q.x, q.y, q.z}},
              {"channels", channels}};
    if (joint.end) json["end"] = json_of(*joint.end);
    joints.push_back(std::move(json));
  }
  Json whole{{"joints", joints}};
  if (skeleton.metres_per_unit) whole["metres_per_unit"] = *skeleton.metres_per_unit;
  if (!skeleton.humanoid.empty()) whole["humanoid"] = skeleton.humanoid;
  return whole.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Result<MotionSkeleton> parse_skeleton(const std::string& text) {
  MotionSkeleton skeleton;
  try {
    const Json whole = Json::parse(text);
    for (const Json& json : whole.at("joints")) {
      skeleton.joints.push_back(joint_of(json));
      const auto before = static_cast<int>(skeleton.joints.size()) - 1;
      if (skeleton.joints.back().parent >= before || (skeleton.joints.back().parent < 0) != (before == 0))
        return bad_input("joint {} of a skeleton hangs from none before it", before);
    }
    if (whole.contains("metres_per_unit")) skeleton.metres_per_unit = whole.at("metres_per_unit").get<double>();
    if (whole.contains("humanoid")) skeleton.humanoid = whole.at("humanoid").get<std::map<std::string, int>>();
  } catch (const Json::exception& error) {
    return bad_input("a skeleton is no such JSON as it should be: {}", error.what());
  }
  if (skeleton.joints.empty()) return bad_input("a skeleton has no joints");
  return skeleton;
}

Bytes sample_bytes(const Motion& motion) {
  Bytes bytes;
  for (const MotionFrame& frame : motion.frames) {
    append(bytes, frame.root);
    for (const Quat& q : frame.rotations)
      for (const double number : {q.w, q.x, q.y, q.z}) append(bytes, number);
    for (const Vec3& offset : frame.offsets) append(bytes, offset);
  }
  return bytes;
}

Result<std::vector<MotionFrame>> parse_samples(std::span<const unsigned char> bytes, std::size_t frames,
                                               std::size_t joints) {
  const std::vector<double> numbers = numbers_of(bytes);
  const std::size_t bare = 3 + 4 * joints, full = bare + 3 * joints;
  const std::size_t each = frames == 0 ? 0 : numbers.size() / frames;
  if (frames == 0 || (each != bare && each != full) || each * frames * sizeof(double) != bytes.size())
    return bad_input("the samples are {} bytes; expected {} frames of {} or {} numbers", bytes.size(), frames, bare,
                     full);
  std::vector<MotionFrame> all(frames);
  const double* at = numbers.data();
  for (MotionFrame& frame : all) {
    frame.root = {at[0], at[1], at[2]};
    at += 3;
    for (std::size_t j = 0; j < joints; ++j, at += 4) frame.rotations.emplace_back(at[0], at[1], at[2], at[3]);
    if (each == full)
      for (std::size_t j = 0; j < joints; ++j, at += 3) frame.offsets.emplace_back(at[0], at[1], at[2]);
  }
  return all;
}

Bytes cut_bytes(const PiecewisePolynomial& curve) {
  Bytes bytes;
  for (const double cut : curve.cuts) append(bytes, cut);
  return bytes;
}

Bytes coefficient_bytes(const PiecewisePolynomial& curve) {
  Bytes bytes;
  if (curve.segments() == 1) {
    for (const double c : curve.coefficients[0]) append(bytes, c);
    return bytes;
  }
  for (std::size_t i = 0; i < curve.segments(); ++i) {
    const auto& c = curve.coefficients[i];
    const auto n = static_cast<Eigen::Index>(std::max<std::size_t>(c.size(), end_unknowns));
    SegmentVector legendre = SegmentVector::Zero(n);
    for (std::size_t k = 0; k < c.size(); ++k) legendre[static_cast<Eigen::Index>(k)] = c[k];
    const double length = curve.cuts[i + 1] - curve.cuts[i];
    const SegmentVector unknowns = solve_square(smooth_basis(static_cast<int>(n) - 1, length, 1.0), legendre);
    append(bytes, static_cast<double>(n));
    append(bytes, unknowns[0]);
    append(bytes, unknowns[1]);
    for (Eigen::Index k = end_unknowns; k < n; ++k) append(bytes, unknowns[k]);
    if (i + 1 == curve.segments()) {
      append(bytes, unknowns[2]);
      append(bytes, unknowns[3]);
    }
  }
  return bytes;
}

Result<PiecewisePolynomial> parse_curve(std::span<const unsigned char> cuts,
                                        std::span<const unsigned char> coefficients) {
  PiecewisePolynomial curve;
  curve.cuts = numbers_of(cuts);
  const std::vector<double> numbers = numbers_of(coefficients);
  if (curve.cuts.size() == 2) {
    curve.coefficients.push_back(numbers);
  } else {
    std::vector<SegmentVector> segments;
    std::size_t at = 0;
    for (std::size_t i = 0; i + 1 < curve.cuts.size(); ++i) {
      const double count = at < numbers.size() ? numbers[at++] : 0.0;
      const double left = static_cast<double>(numbers.size() - at);
      if (!(count >= end_unknowns && count <= max_coefficients && count <= left) || std::floor(count) != count)
        return bad_input("a curve's segment has {} coefficients; expected {} to {}", count, +end_unknowns,
                         +max_coefficients);
      SegmentVector unknowns = SegmentVector::Zero(static_cast<Eigen::Index>(count));
      unknowns[0] = numbers[at++];
      unknowns[1] = numbers[at++];
      for (Eigen::Index k = end_unknowns; k < unknowns.size(); ++k) unknowns[k] = numbers[at++];
      segments.push_back(unknowns);
    }
    if (segments.empty() || at + 2 != numbers.size()) return bad_input("a curve's numbers do not fit its cuts");
    for (std::size_t i = 0; i < segments.size(); ++i) {
      SegmentVector& unknowns = segments[i];
      unknowns[2] = i + 1 < segments.size() ? segments[i + 1][0] : numbers[at];
      unknowns[3] = i + 1 < segments.size() ? segments[i + 1][1] : numbers[at + 1];
      const double length = curve.cuts[i + 1] - curve.cuts[i];
      const SegmentVector c = smooth_basis(static_cast<int>(unknowns.size()) - 1, length, 1.0) * unknowns;
      curve.coefficients.emplace_back(c.begin(), c.end());
    }
  }
  if (auto valid = curve.validate(); !valid) return pass_on(std::move(valid));
  return curve;
}

}  // namespace sinew
