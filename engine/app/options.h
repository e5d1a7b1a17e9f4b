#pragma once
/// What the user asked for, checked as far as that goes without opening a file. tools/ fills these from the command
/// line.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/model/muscle.h"
#include "engine/model/scene.h"

namespace sinew {

/// `--pose JOINT=x,y,z`: degrees about the model's axes.
struct PoseOption {
  std::string joint;
  Vec3 degrees{0.0};
};

/// What render, export, parity and bench share.
struct SceneOptions {
  std::string scene;                       ///< scene file or glTF file; empty: the embedded default
  std::optional<std::vector<int>> frames;  ///< `--frame`, `--frames`
  Deformer deformer = Deformer::ssd;
  BulgeMode bulge = BulgeMode::on;
  std::vector<PoseOption> poses;
  std::optional<ClipChoice> clip;
  std::optional<double> fps;
  std::filesystem::path library;  ///< motion library where the scene names none; empty: the user's own
  double strength = 1.0;          ///< of all muscles, 0 to 1
  std::size_t vertices = 0;       ///< resample every character to about so many; 0: as the file has it
};

/// Each fails as usage, naming the option, the value and what would be right.
Result<PoseOption> parse_pose(std::string_view text);
Result<Deformer> parse_deformer(std::string_view text);
Result<BulgeMode> parse_bulge(std::string_view text);
Result<View> parse_view(std::string_view text);
Result<Shading> parse_shading(std::string_view text);
Result<ComparisonPlace> parse_comparison_place(std::string_view text);
Result<MusclePlot> parse_muscle_plot(std::string_view text);
Result<bool> parse_switch(const char* option, std::string_view text);  ///< "on" or "off"
Result<Colour> parse_background(std::string_view text);
ClipChoice parse_clip(std::string_view text);

struct PictureSize {
  int width = 1280, height = 720;
  bool operator==(const PictureSize&) const = default;
};
Result<PictureSize> parse_size(std::string_view text);
Result<void> check_samples(int samples);

std::string_view deformer_name(Deformer deformer);
std::string_view bulge_name(BulgeMode bulge);

}  // namespace sinew
