#pragma once
/// Heads that several tests look at, made once a program.

#include <map>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "engine/face/expression.h"
#include "engine/face/head.h"

namespace sinew::test {

inline const HeadMaker& maker(int level) {
  static std::map<int, HeadMaker> makers;
  return makers.try_emplace(level, HeadMaker(level)).first->second;
}

inline const std::vector<std::string> age_words = {"adult", "young", "adolescent", "child", "infant"};
inline const std::vector<std::string> skull_words = {"square", "round", "wide", "narrow"};

/// A head by age and skull ("" for none).
inline const Head& head_of(const std::string& age, const std::string& skull = "", int level = 1) {
  static std::map<std::string, Head> heads;
  const std::string key = age + "/" + skull + "/" + std::to_string(level);
  if (!heads.contains(key)) {
    HeadMeasures measures = measures_of_age(parse_age(age).value());
    if (!skull.empty()) apply_skull(parse_skull(skull).value(), measures);
    heads.emplace(key, maker(level).head(measures).value());
  }
  return heads.at(key);
}

/// Positions of an expression at a strength, held at the limits.
inline std::vector<Vec3> shown(const Head& head, const FaceChannels& adult) {
  return posed_positions(head, hold_at_limits(head.face, for_head(head.face, adult)).channels);
}
inline std::vector<Vec3> shown(const Head& head, const std::string& name, double strength) {
  const WeighedExpression one[] = {{find_expression(name).value(), strength}};
  return shown(head, mix_expressions(one, false));
}

}  // namespace sinew::test
