#include "engine/app/figure.h"

#include <filesystem>

#include <nlohmann/json.hpp>

#include "engine/app/comparison.h"
#include "engine/app/muscle_plot.h"
#include "engine/app/panel.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

constexpr int gutter = 8;

/// What a panel shows, before it is made.
struct PanelPlan {
  const Stage* stage = nullptr;
  SceneOptions scene;
  FigureLook figure;
  std::string label;
  std::optional<View> view;  ///< in place of the figure's
};

std::string view_word(View view) { return view_names()[static_cast<std::size_t>(view)]; }

std::string short_name(const Stage& stage) { return std::filesystem::path(stage.source).filename().string(); }

std::vector<PanelPlan> plan_panels(const Stage& stage, const SceneOptions& scene, const FigureLook& figure,
                                   const Stage* other, const LookOptions& look) {
  std::vector<PanelPlan> plans{{&stage, scene, figure, "", std::nullopt}};
  if (!figure.compares()) return plans;
  plans.push_back(plans.front());
  if (other != nullptr) {
    plans[1].stage = other;
    plans[0].label = short_name(stage);
    plans[1].label = short_name(*other);
  } else if (figure.other_view) {
    plans[1].view = figure.other_view;
    plans[0].label = view_word(look.view.value_or(stage.scene.camera.view));
    plans[1].label = view_word(*figure.other_view);
  } else {
    const auto sides = compared_sides(figure.compare, scene, figure.overlay);
    for (std::size_t i = 0; i < 2; ++i) {
      plans[i].scene = sides[i].scene;
      plans[i].figure.overlay = sides[i].overlay;
      plans[i].label = sides[i].label;
    }
  }
  return plans;
}

/// The size of a panel so that a row or a grid of them, with gutters, fits the whole.
PictureSize panel_size(const PictureSize& whole, int columns, int rows) {
  if (columns == 1 && rows == 1) return whole;
  return {std::max((whole.width - (columns + 1) * gutter) / columns, 1),
          std::max((whole.height - (rows + 1) * gutter) / rows, 1)};
}

/// A sheet put into the middle of a picture of exactly the size that was asked for: rounding leaves a few pixels over,
/// which go on as its gutters.
Picture centred(const Picture& inner, const PictureSize& size) {
  if (inner.width == size.width && inner.height == size.height) return inner;
  const Colour paper = SheetOptions{}.background;
  Picture whole{size.width, size.height, {}};
  for (long long i = 0; i < 1LL * size.width * size.height; ++i)
    whole.rgba.insert(whole.rgba.end(), {paper.red, paper.green, paper.blue, paper.alpha});
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
  FigureLook figure;
  std::optional<MusclePlotMaker> plot;
  PictureSize size, frame_size, panel_size;  ///< of the whole, of one frame's panels together, and of one of them
  std::optional<Font> font;

  Result<void> make_panels(Device& device, const std::vector<PanelPlan>& plans, const LookOptions& look,
                           std::vector<std::string>& problems);

  const Font* font_or_null() const { return font ? &*font : nullptr; }

  Result<std::vector<Picture>> panel_pictures(int frame, double orbit);
  Result<Picture> row(int frame, double orbit);
  Result<Picture> contact_sheet(const std::vector<int>& frames);
};

/// The panels of one frame. A comparison that is an inset is already in the first.
Result<std::vector<Picture>> FigureMaker::Impl::panel_pictures(int frame, double orbit) {
  std::vector<Picture> pictures;
  for (PanelMaker& panel : panels) {
    const bool inset = !pictures.empty() && figure.compare_as == ComparisonPlace::inset;
    auto picture = inset && panel.has_near_picture() ? panel.near_picture(frame, orbit, font_or_null())
                                                     : panel.picture(frame, orbit, font_or_null());
    if (!picture) return pass_on(std::move(picture));
    if (!inset) {
      pictures.push_back(std::move(*picture));
      continue;
    }
    const InsetOptions options{.corner = Corner::lower_right, .label = labels[1]};
    if (auto ok = add_inset(pictures[0], *picture, options, font_or_null()); !ok) return pass_on(std::move(ok));
  }
  if (plot) {
    auto picture = plot->picture(frame, panel_size, *font);
    if (!picture) return pass_on(std::move(picture));
    pictures.push_back(std::move(*picture));
  }
  return pictures;
}

Result<Picture> FigureMaker::Impl::row(int frame, double orbit) {
  auto pictures = panel_pictures(frame, orbit);
  if (!pictures) return pass_on(std::move(pictures));
  if (pictures->size() == 1) return std::move(pictures->front());
  std::vector<Panel> cells;
  for (std::size_t i = 0; i < pictures->size(); ++i)
    cells.push_back(
        {&(*pictures)[i], figure.compare_as == ComparisonPlace::panels && i < labels.size() ? labels[i] : ""});
  auto laid_out = sheet(cells, {.gutter = gutter}, font_or_null());
  if (!laid_out) return laid_out;
  return centred(*laid_out, frame_size);
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
    const bool named = std::size_t(i) < figure.captions.size();
    names.push_back(named ? figure.captions[std::size_t(i)] : fmt::format("frame {}", frame));
  }
  std::vector<Panel> cells;
  for (std::size_t i = 0; i < pictures.size(); ++i) cells.push_back({&pictures[i], names[i]});
  auto laid_out = sheet(cells, {.columns = grid.columns, .rows = grid.rows, .gutter = gutter}, font_or_null());
  if (!laid_out) return laid_out;
  return centred(*laid_out, size);
}

FigureMaker::FigureMaker(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FigureMaker::FigureMaker(FigureMaker&&) noexcept = default;
FigureMaker::~FigureMaker() = default;

Result<void> FigureMaker::Impl::make_panels(Device& device, const std::vector<PanelPlan>& plans,
                                            const LookOptions& look, std::vector<std::string>& problems) {
  const bool inset = figure.compare_as == ComparisonPlace::inset;
  for (const PanelPlan& plan : plans) {
    LookOptions panel_look = look;
    panel_look.size = panel_size;
    if (plan.view) panel_look.view = plan.view;
    if (inset && !panels.empty() && figure.zoom.empty()) panel_look.size = inset_size(panel_size);
    std::vector<std::string> found;
    auto panel = PanelMaker::create(device, *plan.stage, plan.scene, panel_look, plan.figure, found);
    if (!panel) return pass_on(std::move(panel));
    if (panels.empty() || plan.stage != plans[0].stage) problems.insert(problems.end(), found.begin(), found.end());
    if (inset && plans.size() > 1) panel->name_inset(panels.empty() ? plan.label : "");
    panels.push_back(std::move(*panel));
    labels.push_back(plan.label);
  }
  return {};
}

Result<FigureMaker> FigureMaker::create(Device& device, const Stage& stage, const SceneOptions& scene,
                                        const LookOptions& look, const FigureLook& figure,
                                        std::vector<std::string>& problems) {
  auto impl = std::make_unique<Impl>();
  impl->figure = figure;
  impl->size = look.size;
  if (!figure.other.empty()) {
    SceneOptions other = scene;
    other.scene = figure.other;
    auto opened = open_stage(other);
    if (!opened) return bad_input("--compare {}: {}", figure.other, opened.error().message);
    problems.insert(problems.end(), opened->problems.begin(), opened->problems.end());
    impl->other = std::make_unique<Stage>(std::move(*opened));
  }
  if (figure.compare == CompareWith::overlay && figure.overlay == OverlayOptions{})
    return bad_input("--compare overlay: no overlay is drawn; name some with --overlay or in the scene's look");
  if (figure.plot != MusclePlot::none) {
    auto plot = MusclePlotMaker::create(stage, figure.plot, scene.bulge);
    if (!plot) return pass_on(std::move(plot));
    impl->plot = std::move(*plot);
  }
  const std::vector<PanelPlan> plans = plan_panels(stage, scene, figure, impl->other.get(), look);
  const Grid grid = figure.sheet.value_or(Grid{});
  impl->frame_size = panel_size(look.size, grid.columns, grid.rows);
  const std::size_t side_by_side = figure.compare_as == ComparisonPlace::inset ? 1 : plans.size();
  impl->panel_size = panel_size(impl->frame_size, static_cast<int>(side_by_side) + (impl->plot ? 1 : 0), 1);
  if (auto ok = impl->make_panels(device, plans, look, problems); !ok) return pass_on(std::move(ok));
  if (figure.overlay.painted() || figure.sheet || plans.size() > 1 || !figure.zoom.empty() || impl->plot) {
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
  const FigureLook& figure = impl_->figure;
  nlohmann::ordered_json json;
  json["figure"] = figure_text(figure);
  if (impl_->other) json["other"] = impl_->other->scene_hash;
  json["labels"] = impl_->labels;
  if (figure.sheet) json["frames"] = frames;
  if (figure.turntable > 0) json["first"] = frames.front();
  return json.dump();
}

Result<Picture> FigureMaker::picture(int number, const std::vector<int>& frames) {
  if (impl_->figure.sheet) return impl_->contact_sheet(frames);
  if (impl_->figure.turntable == 0) return impl_->row(number, 0.0);
  return impl_->row(frames.front(), 360.0 * number / impl_->figure.turntable);
}

}  // namespace sinew
