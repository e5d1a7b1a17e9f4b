#include "engine/model/scene_words.h"

#include <array>
#include <cassert>
#include <charconv>

#include <fmt/format.h>

#include "engine/core/text.h"

namespace sinew {

std::span<const std::string> ease_names() {
  static const std::array<std::string, 4> names{"linear", "smooth", "step", "cubic"};
  return names;
}

std::span<const std::string> side_names() {
  static const std::array<std::string, 2> names{"left", "right"};
  return names;
}

std::span<const std::string> muscle_preset_names() {
  static const std::array<std::string, 8> names{"biceps",     "calf",       "triceps", "forearm_flexors",
                                                "quadriceps", "hamstrings", "deltoid", "pectoral"};
  return names;
}

std::span<const std::string> expression_names() {
  static const std::array<std::string, 10> names{"neutral", "smile", "laugh",   "anger", "surprise",
                                                 "shout",   "fear",  "sadness", "doubt", "disgust"};
  return names;
}

std::span<const std::string> view_names() {
  static const std::array<std::string, 6> names{"front", "back", "left", "right", "top", "three-quarter"};
  return names;
}

std::span<const std::string> projection_names() {
  static const std::array<std::string, 2> names{"perspective", "orthographic"};
  return names;
}

std::span<const std::string> shading_names() {
  static const std::array<std::string, 7> names{"lit", "flat", "clay", "normals", "weights", "bulge", "depth"};
  return names;
}

std::span<const std::string> key_blend_names() {
  static const std::array<std::string, 2> names{"replace", "add"};
  return names;
}

std::span<const std::string> overlay_names() {
  static const std::array<std::string, 11> names{"skeleton", "bones", "muscles",  "arrows", "projection", "box",
                                                 "axes",     "wire",  "wire-all", "guides", "regions"};
  return names;
}

std::span<const std::string> comparison_names() {
  static const std::array<std::string, 4> names{"none", "bulge", "deformer", "overlay"};
  return names;
}

std::span<const std::string> comparison_place_names() {
  static const std::array<std::string, 2> names{"panels", "inset"};
  return names;
}

std::span<const std::string> muscle_plot_names() {
  static const std::array<std::string, 3> names{"none", "angle", "profile"};
  return names;
}

std::span<const std::string> age_names() {
  static const std::array<std::string, 5> names{"adult", "young", "adolescent", "child", "infant"};
  return names;
}

std::span<const std::string> built_in_model_names() {
  static const std::array<std::string, 6> names{"builtin:arm",   "builtin:figure", "builtin:skeleton",
                                                "builtin:woman", "builtin:poser",  "builtin:head"};
  return names;
}

bool is_built_in_model(std::string_view model) { return model.starts_with("builtin:"); }

std::span<const FaceRegion> face_regions() {
  static const std::array<FaceRegion, 19> regions{{{"browLeft", "[right, up, turn]", 3},
                                                   {"browRight", "[right, up, turn]", 3},
                                                   {"upperLidLeft", "[close]", 1},
                                                   {"upperLidRight", "[close]", 1},
                                                   {"lowerLidLeft", "[close]", 1},
                                                   {"lowerLidRight", "[close]", 1},
                                                   {"eyeLeft", "[yaw, pitch]", 2},
                                                   {"eyeRight", "[yaw, pitch]", 2},
                                                   {"upperLip", "[up]", 1},
                                                   {"lowerLip", "[up]", 1},
                                                   {"cornerLeft", "[right, up]", 2},
                                                   {"cornerRight", "[right, up]", 2},
                                                   {"jaw", "[drop]", 1},
                                                   {"cheekLeft", "[up]", 1},
                                                   {"cheekRight", "[up]", 1},
                                                   {"nose", "[wrinkle]", 1},
                                                   {"lipPucker", "[share]", 1},
                                                   {"lipPress", "[share]", 1},
                                                   {"lipSeal", "[share]", 1}}};
  return regions;
}

std::optional<Colour> parse_colour(std::string_view text) {
  std::string wanted = lower(text);
  if (wanted == "transparent") return Colour{0, 0, 0, 0};
  if (wanted == "black") return Colour{0, 0, 0};
  if (wanted == "white") return Colour{255, 255, 255};
  if (!wanted.starts_with('#')) return std::nullopt;
  if (wanted.size() == 4) wanted = {'#', wanted[1], wanted[1], wanted[2], wanted[2], wanted[3], wanted[3]};
  if (wanted.size() != 7 || wanted.find_first_not_of("0123456789abcdef", 1) != std::string::npos) return std::nullopt;
  unsigned value = 0;
  std::from_chars(wanted.data() + 1, wanted.data() + wanted.size(), value, 16);
  return Colour{static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8 & 0xff),
                static_cast<std::uint8_t>(value & 0xff)};
}

std::string colour_text(const Colour& colour) {
  if (colour.alpha == 0) return "transparent";
  return fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue);
}

std::string muscle_name(const MuscleSpec& muscle) {
  if (muscle.name) return *muscle.name;
  assert(muscle.preset && muscle.side);
  return fmt::format("{}_{}", muscle_preset_names()[static_cast<std::size_t>(*muscle.preset)],
                     side_names()[static_cast<std::size_t>(*muscle.side)]);
}

}  // namespace sinew
