#include "engine/app/figure.h"

#include <filesystem>

#include <nlohmann/json.hpp>

#include "engine/app/panel.h"
#include "engine/core/text.h"

namespace sinew {
namespace {

constexpr int gutter = 8;
constexpr int most_grid_places = 400;

/// What a panel shows, before it is made.
struct PanelPlan {
  const Stage* stage = nullptr;
  SceneOptions scene;
  std::string label;
};

std::string short_name(const Stage& stage) { return std::filesystem::path(stage.source).filename().string(); }

std::vector<PanelPlan> plan_panels(const Stage& stage, const SceneOptions& scene, const FigureOptions& figure,
                                   const Stage* other) {
  std::vector<PanelPlan> plans{{&stage, scene, ""}};
  if (figure.compare.empty()) return plans;
  plans.push_back(plans.front());
  if (figure.compare == "bulge") {
    if (scene.bulge == BulgeMode::off) plans[0].scene.bulge = BulgeMode::on;
    plans[1].scene.bulge = BulgeMode::off;
    plans[0].label = "with bulge";
    plans[1].label = "without bulge";
  } else if (figure.compare == "deformer") {
    plans[0].scene.deformer = Deformer::rigid;
    plans[1].scene.deformer = Deformer::ssd;
    for (PanelPlan& plan : plans) plan.label = deformer_name(plan.scene.deformer);
  } else {
    plans[1].stage = other;
    plans[0].label = short_name(stage);
    plans[1].label = short_name(*other);
  }
  return plans;
}

/// The size of a panel so that a row or a grid of them, with gutters, fits the whole.
PictureSize panel_size(const PictureSize& whole, int columns, int rows) {
  if (columns == 1 && rows == 1) return whole;
  return {std::max((whole.width - (columns + 1) * gutter) / columns, 1),
          std::max((whole.height - (rows + 1) * gutter) / rows, 1)};
}

std::array<std::uint8_t, 4> background_bytes(const Stage& stage, const LookOptions& look) {
  const Colour colour = look.background.value_or(stage.scene.look.background);
  return {colour.red, colour.green, colour.blue, colour.alpha};
}

/// A sheet put into the middle of a picture of exactly the size that was asked for: rounding leaves a few pixels over.
Picture centred(const Picture& inner, const PictureSize& size, const std::array<std::uint8_t, 4>& background) {
  if (inner.width == size.width && inner.height == size.height) return inner;
  Picture whole{size.width, size.height, {}};
  whole.rgba.resize(std::size_t{4} * size.width * size.height);
  for (std::size_t i = 0; i < whole.rgba.size(); ++i) whole.rgba[i] = background[i % 4];
  const int left = std::max((size.width - inner.width) / 2, 0), top = std::max((size.height - inner.height) / 2, 0);
  const int width = std::min(inner.width, size.width), height = std::min(inner.height, size.height);
  for (int y = 0; y < height; ++y)
    std::copy_n(&inner.rgba[std::size_t(y) * inner.width * 4], std::size_t(width) * 4,
                &whole.rgba[(std::size_t(y + top) * size.width + left) * 4]);
  return whole;
}

}  // namespace

struct FigureMaker::Impl {
  std::unique_ptr<Stage> other;  ///< the scene that is compared with
  std::vector<PanelMaker> panels;
  std::vector<std::string> labels;
  FigureOptions figure;
  PictureSize size, frame_size;  ///< of the whole, and of one frame's panels together
  std::array<std::uint8_t, 4> background{};
  std::optional<Font> font;

  const Font* font_or_null() const { return font ? &*font : nullptr; }

  Result<Picture> row(int frame, double orbit);
  Result<Picture> contact_sheet(const std::vector<int>& frames);
};

Result<Picture> FigureMaker::Impl::row(int frame, double orbit) {
  std::vector<Picture> pictures;
  for (PanelMaker& panel : panels) {
    auto picture = panel.picture(frame, orbit, font_or_null());
    if (!picture) return picture;
    pictures.push_back(std::move(*picture));
  }
  if (pictures.size() == 1) return std::move(pictures.front());
  std::vector<Panel> cells;
  for (std::size_t i = 0; i < pictures.size(); ++i) cells.push_back({&pictures[i], labels[i]});
  auto laid_out = sheet(cells, {.gutter = gutter}, font_or_null());
  if (!laid_out) return laid_out;
  return centred(*laid_out, frame_size, background);
}

Result<Picture> FigureMaker::Impl::contact_sheet(const std::vector<int>& frames) {
  const Grid& grid = *figure.sheet;
  const int places = std::min<int>(grid.columns * grid.rows, static_cast<int>(frames.size()));
  std::vector<Picture> pictures;
  std::vector<std::string> names;
  for (int i = 0; i < places; ++i) {
    const std::size_t last = frames.size() - 1;
    const int frame =
        frames[places == 1 ? 0 : (last * std::size_t(i) + std::size_t(places - 1) / 2) / std::size_t(places - 1)];
    auto picture = row(frame, 0.0);
    if (!picture) return picture;
    pictures.push_back(std::move(*picture));
    names.push_back(fmt::format("frame {}", frame));
  }
  std::vector<Panel> cells;
  for (std::size_t i = 0; i < pictures.size(); ++i) cells.push_back({&pictures[i], names[i]});
  auto laid_out = sheet(cells, {.columns = grid.columns, .rows = grid.rows, .gutter = gutter}, font_or_null());
  if (!laid_out) return laid_out;
  return centred(*laid_out, size, background);
}

Result<OverlayOptions> parse_overlay(std::string_view text) {
  OverlayOptions overlay;
  const std::pair<const char*, bool*> words[] = {
      {"skeleton", &overlay.skeleton}, {"muscles", &overlay.muscles}, {"box", &overlay.box}, {"axes", &overlay.axes}};
  std::vector<std::string> known;
  for (const auto& [word, flag] : words) known.emplace_back(word);
  known.insert(known.end(), {"wire", "wire-all"});
  for (const std::string& asked : split(text, ',')) {
    if (asked == "guides" || asked == "regions")
      return failure(ErrorKind::usage, "--overlay {}: does not exist yet; expected some of {}", asked,
                     fmt::join(known, ", "));
    const auto found = std::find(known.begin(), known.end(), asked);
    if (found == known.end())
      return failure(ErrorKind::usage, "--overlay {}: expected some of {}, separated by commas{}", asked,
                     fmt::join(known, ", "), did_you_mean(asked, known));
    if (asked == "wire" || asked == "wire-all")
      overlay.wire = asked == "wire" ? WireMode::visible : WireMode::all;
    else
      *words[found - known.begin()].second = true;
  }
  return overlay;
}

Result<Grid> parse_grid(std::string_view text) {
  const std::vector<std::string> parts = split(text, 'x');
  if (parts.size() == 2) {
    const auto columns = parse_integer(parts[0]), rows = parse_integer(parts[1]);
    if (columns && rows && *columns > 0 && *rows > 0 && *columns <= most_grid_places && *rows <= most_grid_places &&
        *columns * *rows <= most_grid_places)
      return Grid{static_cast<int>(*columns), static_cast<int>(*rows)};
  }
  return failure(ErrorKind::usage, "--sheet {}: expected COLUMNSxROWS, at most {} places", text, most_grid_places);
}

FigureMaker::FigureMaker(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FigureMaker::FigureMaker(FigureMaker&&) noexcept = default;
FigureMaker::~FigureMaker() = default;

Result<FigureMaker> FigureMaker::create(Device& device, const Stage& stage, const SceneOptions& scene,
                                        const LookOptions& look, const FigureOptions& figure,
                                        std::vector<std::string>& problems) {
  auto impl = std::make_unique<Impl>();
  impl->figure = figure;
  impl->size = look.size;
  impl->background = background_bytes(stage, look);
  const bool with_other = !figure.compare.empty() && figure.compare != "bulge" && figure.compare != "deformer";
  if (with_other) {
    SceneOptions other = scene;
    other.scene = figure.compare;
    auto opened = open_stage(other);
    if (!opened) return bad_input("--compare {}: {}", figure.compare, opened.error().message);
    problems.insert(problems.end(), opened->problems.begin(), opened->problems.end());
    impl->other = std::make_unique<Stage>(std::move(*opened));
  }
  const std::vector<PanelPlan> plans = plan_panels(stage, scene, figure, impl->other.get());
  const Grid grid = figure.sheet.value_or(Grid{});
  impl->frame_size = panel_size(look.size, grid.columns, grid.rows);
  LookOptions panel_look = look;
  panel_look.size = panel_size(impl->frame_size, static_cast<int>(plans.size()), 1);
  for (const PanelPlan& plan : plans) {
    std::vector<std::string> found;
    auto panel = PanelMaker::create(device, *plan.stage, plan.scene, panel_look, figure, found);
    if (!panel) return pass_on(std::move(panel));
    if (impl->panels.empty() || plan.stage != &stage) problems.insert(problems.end(), found.begin(), found.end());
    impl->panels.push_back(std::move(*panel));
    impl->labels.push_back(plan.label);
  }
  if (figure.overlay.painted() || figure.sheet || plans.size() > 1 || !figure.zoom.empty()) {
    auto font = Font::find();
    if (!font) return pass_on(std::move(font));
    impl->font = std::move(*font);
  }
  return FigureMaker(std::move(impl));
}

std::vector<int> FigureMaker::numbers(const std::vector<int>& frames) const {
  if (impl_->figure.sheet) return {frames.front()};
  if (impl_->figure.turntable == 0) return frames;
  std::vector<int> steps;
  for (int i = 0; i < impl_->figure.turntable; ++i) steps.push_back(i);
  return steps;
}

std::string FigureMaker::recipe(const std::vector<int>& frames) const {
  const FigureOptions& figure = impl_->figure;
  nlohmann::ordered_json json;
  json["overlay"] = {figure.overlay.skeleton, figure.overlay.muscles, figure.overlay.box, figure.overlay.axes,
                     static_cast<int>(figure.overlay.wire)};
  json["compare"] = impl_->other ? impl_->other->scene_hash : figure.compare;
  json["labels"] = impl_->labels;
  json["zoom"] = figure.zoom;
  if (figure.sheet) json["sheet"] = {figure.sheet->columns, figure.sheet->rows, frames};
  if (figure.turntable > 0) json["turntable"] = {figure.turntable, frames.front()};
  return json.dump();
}

Result<Picture> FigureMaker::picture(int number, const std::vector<int>& frames) {
  if (impl_->figure.sheet) return impl_->contact_sheet(frames);
  if (impl_->figure.turntable == 0) return impl_->row(number, 0.0);
  return impl_->row(frames.front(), 360.0 * number / impl_->figure.turntable);
}

}  // namespace sinew
