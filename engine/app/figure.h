#pragma once
/// Pictures that explain: overlays, panels side by side, insets, contact sheets, turntables. A plain picture is the
/// figure with nothing added.

#include <map>

#include "engine/app/frame.h"
#include "engine/render/overlay.h"
#include "engine/render/sheet.h"

namespace sinew {

/// What is drawn over a picture.
struct OverlayOptions {
  bool skeleton = false;  ///< bones, joints and their names
  bool muscles = false;   ///< planes, regions, centres, ellipses
  bool box = false;       ///< the deformed vertices' box
  bool axes = false;
  WireMode wire = WireMode::none;  ///< drawn with the surface itself

  /// Whether anything is painted over the finished picture.
  bool painted() const { return skeleton || muscles || box || axes; }
};

/// `--overlay skeleton,muscles`; `wire` shows the mesh's visible edges, `wire-all` hidden ones too. Fails as usage.
Result<OverlayOptions> parse_overlay(std::string_view text);

/// Frames of a sequence in one picture.
struct Grid {
  int columns = 1, rows = 1;
};

/// `--sheet 4x3`. Fails as usage.
Result<Grid> parse_grid(std::string_view text);

struct FigureOptions {
  OverlayOptions overlay;
  std::string compare;        ///< "bulge", "deformer", or a scene or model that stands beside; empty: one panel
  std::string zoom;           ///< joint that an inset shows near by; empty: none
  std::optional<Grid> sheet;  ///< evenly spaced frames of the selected ones, labelled
  int turntable = 0;          ///< so many pictures round the first selected frame; 0: none
};

/// Makes the pictures of a figure. The size that was asked for is that of the whole, panels and gutters included.
/// Device and stage must outlive it.
class FigureMaker {
 public:
  /// Fails as bad_input where the joint to zoom on or the scene to compare with is not there, as cannot_write where
  /// labels are needed and no font is installed.
  static Result<FigureMaker> create(Device& device, const Stage& stage, const SceneOptions& scene,
                                    const LookOptions& look, const FigureOptions& figure,
                                    std::vector<std::string>& problems);
  FigureMaker(FigureMaker&&) noexcept;
  ~FigureMaker();

  /// The numbers of the pictures that the selected frames ask for: frames, turntable steps, or one sheet.
  std::vector<int> numbers(const std::vector<int>& frames) const;

  /// What the pictures of these frames show beyond the scene and its look, as text for the recipe.
  std::string recipe(const std::vector<int>& frames) const;

  /// The picture of one of those numbers.
  Result<Picture> picture(int number, const std::vector<int>& frames);

 private:
  struct Impl;
  explicit FigureMaker(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace sinew
