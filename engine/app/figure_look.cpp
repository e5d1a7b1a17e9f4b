#include "engine/app/figure_look.h"

#include <array>
#include <utility>

#include <nlohmann/json.hpp>

#include "engine/core/text.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

/// The switch that each overlay but those of wires turns on.
constexpr std::array<std::pair<Overlay, bool OverlayOptions::*>, 9> switches{
    {{Overlay::skeleton, &OverlayOptions::skeleton},
     {Overlay::bones, &OverlayOptions::bones},
     {Overlay::muscles, &OverlayOptions::muscles},
     {Overlay::arrows, &OverlayOptions::arrows},
     {Overlay::projection, &OverlayOptions::projection},
     {Overlay::box, &OverlayOptions::box},
     {Overlay::axes, &OverlayOptions::axes},
     {Overlay::guides, &OverlayOptions::guides},
     {Overlay::regions, &OverlayOptions::regions}}};

OverlayOptions overlay_options(std::span<const Overlay> overlays) {
  OverlayOptions options;
  for (const Overlay asked : overlays) {
    for (const auto& [overlay, flag] : switches)
      if (asked == overlay) options.*flag = true;
    if (asked == Overlay::wire) options.wire = WireMode::visible;
    if (asked == Overlay::wire_all) options.wire = WireMode::all;
  }
  return options;
}

}  // namespace

Result<OverlayOptions> parse_overlay(std::string_view text) {
  if (text == "none") return OverlayOptions{};
  const auto known = overlay_names();
  std::vector<Overlay> overlays;
  for (const std::string& asked : split(text, ',')) {
    const auto found = std::ranges::find(known, asked);
    if (found == known.end())
      return failure(ErrorKind::usage, "--overlay {}: expected none, or some of {}, separated by commas{}", asked,
                     fmt::join(known, ", "), did_you_mean(asked, known));
    overlays.push_back(static_cast<Overlay>(found - known.begin()));
  }
  return overlay_options(overlays);
}

std::string overlay_words(const OverlayOptions& options) {
  const auto names = overlay_names();
  std::vector<std::string> words;
  for (const auto& [overlay, flag] : switches)
    if (options.*flag) words.push_back(names[static_cast<std::size_t>(overlay)]);
  if (options.wire != WireMode::none) words.push_back(options.wire == WireMode::all ? "wire-all" : "wire");
  return fmt::format("{}", fmt::join(words, ", "));
}

Result<Grid> parse_grid(std::string_view text) {
  if (text == "none") return no_grid;
  const std::vector<std::string> parts = split(text, 'x');
  if (parts.size() == 2) {
    const auto columns = parse_integer(parts[0]), rows = parse_integer(parts[1]);
    if (columns && rows && *columns > 0 && *rows > 0 && *columns <= most_grid_places && *rows <= most_grid_places &&
        *columns * *rows <= most_grid_places)
      return Grid{static_cast<int>(*columns), static_cast<int>(*rows)};
  }
  return failure(ErrorKind::usage, "--sheet {}: expected COLUMNSxROWS, at most {} places, or none", text,
                 most_grid_places);
}

FigureLook figure_look(const FigureOptions& options, const Look& look) {
  FigureLook figure;
  figure.overlay = options.overlay.value_or(overlay_options(look.overlay));
  figure.compare = look.compare;
  if (options.compare) {
    const auto words = comparison_names();
    const auto word = std::ranges::find(words, *options.compare);
    figure.compare = word == words.end() ? CompareWith::none : static_cast<CompareWith>(word - words.begin());
    if (word == words.end()) {
      const auto views = view_names();
      const auto view = std::ranges::find(views, *options.compare);
      if (view != views.end())
        figure.other_view = static_cast<View>(view - views.begin());
      else
        figure.other = *options.compare;
    }
  }
  figure.compare_as = options.compare_as.value_or(look.compare_as);
  figure.zoom = options.zoom.value_or(look.zoom);
  if (figure.zoom == "none") figure.zoom.clear();
  figure.plot = options.plot.value_or(look.plot);
  figure.turntable = options.turntable;
  if (options.sheet && options.sheet != no_grid) figure.sheet = options.sheet;
  if (options.sheet || figure.turntable > 0) return figure;
  figure.sheet = look.sheet;
  figure.captions = look.captions;
  return figure;
}

std::string figure_text(const FigureLook& figure) {
  nlohmann::ordered_json json;
  json["overlay"] = overlay_words(figure.overlay);
  json["compare"] = {static_cast<int>(figure.compare), static_cast<int>(figure.compare_as)};
  if (figure.other_view) json["other_view"] = static_cast<int>(*figure.other_view);
  json["zoom"] = figure.zoom;
  json["plot"] = static_cast<int>(figure.plot);
  if (figure.sheet) json["sheet"] = {figure.sheet->columns, figure.sheet->rows, figure.captions};
  json["turntable"] = figure.turntable;
  return json.dump();
}

}  // namespace sinew
