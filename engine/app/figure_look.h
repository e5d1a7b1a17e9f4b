#pragma once
/// What a figure shows beyond the plain picture: the command line's words over the scene's.

#include <optional>
#include <string>
#include <string_view>

#include "engine/core/result.h"
#include "engine/model/scene.h"
#include "engine/render/wire_mode.h"

namespace sinew {

/// What is drawn over a picture.
struct OverlayOptions {
  bool skeleton = false;    ///< bones, joints and their names
  bool bones = false;       ///< the same without names
  bool muscles = false;     ///< planes, regions, centres, ellipses
  bool arrows = false;      ///< the regions' normals
  bool projection = false;  ///< the regions and what they are on their planes, with the centres
  bool box = false;         ///< the deformed vertices' box
  bool axes = false;
  bool guides = false;             ///< the lines that a head is drawn by
  bool regions = false;            ///< a face's regions, their pivots and limits
  WireMode wire = WireMode::none;  ///< drawn with the surface itself

  bool of_muscles() const { return muscles || arrows || projection; }
  bool of_faces() const { return guides || regions; }
  /// Whether anything is painted over the finished picture.
  bool painted() const { return skeleton || bones || of_muscles() || of_faces() || box || axes; }

  bool operator==(const OverlayOptions&) const = default;
};

/// `--overlay skeleton,muscles`, or `none`; `wire` shows the mesh's visible edges, `wire-all` hidden ones too. Fails as
/// usage.
Result<OverlayOptions> parse_overlay(std::string_view text);

/// The same words again, "skeleton, wire".
std::string overlay_words(const OverlayOptions& overlay);

/// `--sheet none`: the scene's is taken away.
constexpr Grid no_grid{0, 0};

/// `--sheet 4x3`. Fails as usage.
Result<Grid> parse_grid(std::string_view text);

/// What the command line asks for; what it does not say is the scene's.
struct FigureOptions {
  std::optional<OverlayOptions> overlay;
  std::optional<std::string>
      compare;  ///< one of comparison_names() or view_names(), or a scene or model that stands beside
  std::optional<ComparisonPlace> compare_as;
  std::optional<std::string> zoom;  ///< joint or muscle that an inset shows near by; "none": no inset
  std::optional<MusclePlot> plot;
  std::optional<Grid> sheet;  ///< evenly spaced frames of the selected ones, labelled
  int turntable = 0;          ///< so many pictures round the first selected frame; 0: none
};

/// The same with nothing left open.
struct FigureLook {
  OverlayOptions overlay;
  CompareWith compare = CompareWith::none;
  std::string other;               ///< scene or model that stands beside; empty: none
  std::optional<View> other_view;  ///< the same, seen from elsewhere, stands beside
  ComparisonPlace compare_as = ComparisonPlace::panels;
  std::string zoom;  ///< empty: no inset
  MusclePlot plot = MusclePlot::none;
  std::optional<Grid> sheet;
  std::vector<std::string> captions;  ///< of the sheet's first pictures
  int turntable = 0;

  bool compares() const { return compare != CompareWith::none || !other.empty() || other_view; }
};

/// The options over the scene's look. A turntable is no sheet, whatever the scene says.
FigureLook figure_look(const FigureOptions& options, const Look& look);

/// Every word of it, as text for a recipe.
std::string figure_text(const FigureLook& figure);

}  // namespace sinew
