#include "engine/app/muscle_plot.h"

#include "engine/rig/joint_angle.h"

namespace sinew {
namespace {

/// A unit is taken for a metre.
constexpr double millimetres = 1000.0;
constexpr int samples = 361;

/// From 0 to a little above the highest curve.
PlotAxis height_axis(const std::vector<PlotCurve>& curves) {
  double low = 0.0, high = 0.0;
  for (const PlotCurve& curve : curves)
    for (const Vec2& p : curve.points) {
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
  if (high - low < 1e-9) high = low + 1.0;
  return {"height, mm", low, high + 0.12 * (high - low), round_step(high - low, 5)};
}

/// The height along the limb over the region's centre line. The spread's and the weights' fades are left out.
double centre_line_height(const PlacedMuscle& placed, double activation, double x, BulgeMode mode) {
  const Muscle& muscle = placed.muscle;
  const ProjectionPlane& plane = placed.region.plane;
  RegionVertex v;
  v.x = x;
  v.t = (glm::dot(placed.region.centre - plane.bone, plane.axis) + x) / plane.length;
  v.share = 1.0;
  if (v.t < muscle.from || v.t > muscle.to) return 0.0;
  const double fade = mode == BulgeMode::paper ? 1.0 : region_fade(muscle, v).value;
  return activation * muscle.peak * std::exp(-0.5 * x * x / (muscle.sigma.x * muscle.sigma.x)) * fade;
}

}  // namespace

Result<MusclePlotMaker> MusclePlotMaker::create(const Stage& stage, MusclePlot kind, BulgeMode bulge) {
  for (std::size_t i = 0; i < stage.characters.size(); ++i)
    if (!stage.characters[i].muscles.empty()) return MusclePlotMaker(stage, i, kind, bulge);
  return bad_input("--plot: {} has no muscle to plot", stage.source);
}

Plot MusclePlotMaker::by_angle(const CharacterState& state) const {
  const StagedCharacter& character = stage_->characters[character_];
  Plot plot;
  plot.title = "Swelling by the joint's angle";
  plot.x = {"angle of the joint, degrees (180: straight)", 180.0, 0.0, 30.0};
  for (std::size_t m = 0; m < character.muscles.size(); ++m) {
    const Muscle& muscle = character.muscles[m].muscle;
    const auto height = [&](double angle) {
      return millimetres * stage_->strength * muscle.peak * muscle_activation(muscle, angle);
    };
    PlotCurve curve{muscle.name, {}, plot_colour(m)};
    for (int i = 0; i < samples; ++i) {
      const double angle = 180.0 * i / (samples - 1);
      curve.points.emplace_back(angle, height(angle));
    }
    plot.curves.push_back(std::move(curve));
    const double now = character.muscles[m].driver.degrees(state.global);
    plot.marks.push_back({{now, height(now)},
                          fmt::format("{:.0f}\u00b0", now),
                          plot_colour(m),
                          muscle.reference_angle < muscle.rest_angle});
  }
  plot.y = height_axis(plot.curves);
  return plot;
}

Plot MusclePlotMaker::along_limb(const CharacterState& state) const {
  const StagedCharacter& character = stage_->characters[character_];
  Plot plot;
  plot.title = "Swelling along the limb";
  double reach = 0.0;
  for (const PlacedMuscle& placed : character.muscles)
    reach = std::max({reach, 3.0 * placed.muscle.sigma.x, 0.5 * placed.region.plane.length});
  for (std::size_t m = 0; m < character.muscles.size(); ++m) {
    const PlacedMuscle& placed = character.muscles[m];
    for (const BulgeMode mode : {BulgeMode::on, BulgeMode::paper}) {
      const bool paper = mode == BulgeMode::paper;
      // One entry tells what dashes are.
      const std::string name = paper ? (m == 0 ? "hard edge" : "") : placed.muscle.name;
      PlotCurve curve{name, {}, plot_colour(m), paper};
      for (int i = 0; i < samples; ++i) {
        const double x = reach * (2.0 * i / (samples - 1) - 1.0);
        curve.points.emplace_back(millimetres * x,
                                  millimetres * centre_line_height(placed, state.activations[m], x, mode));
      }
      plot.curves.push_back(std::move(curve));
    }
    const double sigma = placed.muscle.sigma.x;
    plot.marks.push_back({millimetres * Vec2(sigma, centre_line_height(placed, state.activations[m], sigma, bulge_)),
                          "\u03c3", plot_colour(m)});
  }
  plot.x = {"from the region's centre along the limb, mm", -millimetres * reach, millimetres * reach,
            round_step(2.0 * millimetres * reach, 6)};
  plot.y = height_axis(plot.curves);
  return plot;
}

Plot MusclePlotMaker::plot(int frame) const {
  const CharacterState state = character_state(*stage_, character_, frame);
  return kind_ == MusclePlot::angle ? by_angle(state) : along_limb(state);
}

Result<Picture> MusclePlotMaker::picture(int frame, const PictureSize& size, const Font& font) const {
  return draw_plot(plot(frame), size.width, size.height, font);
}

}  // namespace sinew
