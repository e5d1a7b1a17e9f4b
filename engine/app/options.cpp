#include "engine/app/options.h"

#include <array>

#include "engine/core/text.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

constexpr std::array<std::string_view, 2> deformer_words{"rigid", "ssd"};
constexpr std::array<std::string_view, 3> bulge_words{"off", "on", "paper"};
/// Beyond so many degrees the number is a mistake, and turns lose their precision.
constexpr double largest_angle = 1e6;
/// Named in the manual, but not built yet.
constexpr std::array<std::string_view, 2> later_deformers{"dqs", "cor"};

/// The word's place in the list, which is that of its enum.
template <class Enum, class Words>
Result<Enum> parse_word(const char* option, std::string_view text, const Words& words) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (text == words[i]) return static_cast<Enum>(i);
    known.emplace_back(words[i]);
  }
  return failure(ErrorKind::usage, "{} {}: expected one of {}{}", option, text, fmt::join(known, ", "),
                 did_you_mean(text, known));
}

}  // namespace

Result<PoseOption> parse_pose(std::string_view text) {
  const auto wrong = [&](const char* what) {
    return failure(ErrorKind::usage, "--pose {}: {}; expected JOINT=x,y,z with three angles in degrees", text, what);
  };
  const std::size_t equals = text.rfind('=');
  if (equals == std::string_view::npos || equals == 0) return wrong("no joint is named");
  const std::vector<std::string> parts = split(text.substr(equals + 1), ',');
  if (parts.size() != 3) return wrong("there are not three angles");
  PoseOption pose{std::string(text.substr(0, equals)), {}};
  for (int i = 0; i < 3; ++i) {
    const auto angle = parse_number(parts[i]);
    if (!angle) return wrong("an angle is no number");
    if (std::abs(*angle) > largest_angle) return wrong("an angle is out of range");
    pose.degrees[i] = *angle;
  }
  return pose;
}

Result<Deformer> parse_deformer(std::string_view text) {
  for (std::string_view later : later_deformers)
    if (text == later)
      return failure(ErrorKind::usage, "--deformer {}: does not exist yet; expected one of {}", text,
                     fmt::join(deformer_words, ", "));
  return parse_word<Deformer>("--deformer", text, deformer_words);
}

Result<BulgeMode> parse_bulge(std::string_view text) { return parse_word<BulgeMode>("--bulge", text, bulge_words); }

Result<View> parse_view(std::string_view text) { return parse_word<View>("--view", text, view_names()); }

Result<Shading> parse_shading(std::string_view text) { return parse_word<Shading>("--shading", text, shading_names()); }

Result<ComparisonPlace> parse_comparison_place(std::string_view text) {
  return parse_word<ComparisonPlace>("--compare-as", text, comparison_place_names());
}

Result<MusclePlot> parse_muscle_plot(std::string_view text) {
  return parse_word<MusclePlot>("--plot", text, muscle_plot_names());
}

Result<bool> parse_switch(const char* option, std::string_view text) {
  constexpr std::array<std::string_view, 2> words{"off", "on"};
  return parse_word<bool>(option, text, words);
}

Result<Colour> parse_background(std::string_view text) {
  if (const auto colour = parse_colour(text)) return *colour;
  return failure(ErrorKind::usage, "--background {}: expected a colour such as #d8d8d8, black, white or transparent",
                 text);
}

ClipChoice parse_clip(std::string_view text) {
  if (text == "none") return NoClip{};
  const auto index = parse_integer(text);
  if (index && *index >= 0 && *index <= 1'000'000) return static_cast<int>(*index);
  return std::string(text);
}

Result<PictureSize> parse_size(std::string_view text) {
  const std::vector<std::string> parts = split(text, 'x');
  constexpr long long largest = 16384;
  if (parts.size() == 2) {
    const auto width = parse_integer(parts[0]), height = parse_integer(parts[1]);
    if (width && height && *width > 0 && *height > 0 && *width <= largest && *height <= largest)
      return PictureSize{static_cast<int>(*width), static_cast<int>(*height)};
  }
  return failure(ErrorKind::usage, "--size {}: expected WIDTHxHEIGHT, each from 1 to {}", text, largest);
}

std::string_view deformer_name(Deformer deformer) { return deformer_words[static_cast<std::size_t>(deformer)]; }
std::string_view bulge_name(BulgeMode bulge) { return bulge_words[static_cast<std::size_t>(bulge)]; }

Result<void> check_samples(int samples) {
  if (samples == 1 || samples == 4) return {};
  return failure(ErrorKind::usage, "--samples {}: expected 1 or 4", samples);
}

}  // namespace sinew
