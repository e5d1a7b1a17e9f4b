#pragma once
/// The words that scene files and command lines use for what scene.h holds. Lists stand in the order of their enum.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/model/scene.h"

namespace sinew {

std::span<const std::string> ease_names();
std::span<const std::string> side_names();
std::span<const std::string> muscle_preset_names();
std::span<const std::string> expression_names();  ///< also the tags that a motion may carry
std::span<const std::string> view_names();
std::span<const std::string> projection_names();
std::span<const std::string> shading_names();
std::span<const std::string> key_blend_names();
std::span<const std::string> overlay_names();
std::span<const std::string> comparison_names();
std::span<const std::string> comparison_place_names();
std::span<const std::string> muscle_plot_names();

/// The ages of heads: 0, 0.25 ... 1.
std::span<const std::string> age_names();

/// Models that need no file; a scene names them where a path could stand.
std::span<const std::string> built_in_model_names();

/// True for every name that asks for a built-in model, known or not: it begins with "builtin:".
bool is_built_in_model(std::string_view model);

/// A part of the face that keys can move, and the numbers it takes.
struct FaceRegion {
  std::string name;
  std::string shape;    ///< the numbers as people write them: "[right, up, turn]"
  std::size_t numbers;  ///< how many
};
std::span<const FaceRegion> face_regions();

/// "#rgb", "#rrggbb", "black", "white" or "transparent", letter case ignored; else nothing.
std::optional<Colour> parse_colour(std::string_view text);

/// The same colour as parse_colour() reads it. Only alpha 0 (all such colours are one, "transparent") and 255 exist.
std::string colour_text(const Colour& colour);

/// The muscle's name, or its preset's and side's: "biceps_left".
std::string muscle_name(const MuscleSpec& muscle);

}  // namespace sinew
