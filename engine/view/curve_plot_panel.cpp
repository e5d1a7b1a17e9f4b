#include "engine/view/curve_plot_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include "engine/render/plot.h"

namespace sinew {
namespace {

constexpr float left_margin = 46.0f, bottom_margin = 20.0f, residual_height = 46.0f, gap = 8.0f;
constexpr double handle_pixels = 34.0, reach_pixels = 8.0;
/// A key keeps its time while the pointer stays so near.
constexpr double time_pixels = 8.0;

const ImU32 grid_colour = IM_COL32(255, 255, 255, 22), text_colour = IM_COL32(255, 255, 255, 130);
const ImU32 cut_colour = IM_COL32(255, 255, 255, 60), dot_colour = IM_COL32(140, 190, 255, 190);
const ImU32 curve_colour = IM_COL32(240, 145, 90, 255), now_colour = IM_COL32(255, 255, 255, 150);
const ImU32 key_colour = IM_COL32(242, 205, 90, 255), handle_colour = IM_COL32(242, 205, 90, 150);
const ImU32 residual_colour = IM_COL32(120, 210, 150, 255), plot_colour = IM_COL32(24, 26, 30, 255);
const ImU32 caption_colour = IM_COL32(24, 26, 30, 210);

ImVec2 pixel(const Vec2& p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

/// A plot's ground with its grid, numbers at the lines.
void draw_ground(ImDrawList& draw, const PlotScale& scale, const char* unit, bool with_times) {
  const ImVec2 low = pixel(scale.corner), high = pixel(scale.corner + scale.size);
  draw.AddRectFilled(low, high, plot_colour);
  const auto text = [&](ImVec2 at, float align, const std::string& words) {
    const ImVec2 size = ImGui::CalcTextSize(words.c_str());
    draw.AddText({at.x - align * size.x, at.y - 0.5f * size.y}, text_colour, words.c_str());
  };
  const double rise = round_step(scale.y.length(), std::max(2, static_cast<int>(scale.size.y / 40.0)));
  for (double y = std::ceil(scale.y.low / rise) * rise; y <= scale.y.high; y += rise) {
    const float at = pixel(scale.to_pixel(scale.x.low, y)).y;
    draw.AddLine({low.x, at}, {high.x, at}, grid_colour);
    if (at > low.y + 6.0f && at < high.y - 6.0f)
      text({low.x - 5.0f, at}, 1.0f, fmt::format("{:g}", std::abs(y) < 1e-9 * rise ? 0.0 : y));
  }
  if (!with_times) return;
  const double run = round_step(scale.x.length(), std::max(2, static_cast<int>(scale.size.x / 100.0)));
  for (double x = std::ceil(scale.x.low / run) * run; x <= scale.x.high; x += run) {
    const float at = pixel(scale.to_pixel(x, scale.y.low)).x;
    draw.AddLine({at, low.y}, {at, high.y}, grid_colour);
    if (at < high.x - 26.0f) text({at, high.y + 11.0f}, 0.5f, fmt::format("{:g}", std::abs(x) < 1e-9 * run ? 0.0 : x));
  }
  text({high.x, high.y + 11.0f}, 1.0f, unit);
}

/// Words at a plot's upper left corner, legible over what is plotted, in as many lines as they need.
void draw_caption(ImDrawList& draw, const PlotScale& scale, const std::string& words) {
  if (words.empty()) return;
  const ImVec2 corner = pixel(scale.corner);
  const float room = static_cast<float>(scale.size.x) - 12.0f;
  const ImVec2 size = ImGui::CalcTextSize(words.c_str(), nullptr, false, room);
  draw.AddRectFilled(corner, {corner.x + size.x + 12.0f, corner.y + size.y + 4.0f}, caption_colour);
  draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {corner.x + 6.0f, corner.y + 2.0f}, text_colour, words.c_str(),
               nullptr, room);
}

/// Points of the curve over the part of the time that is shown, in the plot's units.
std::vector<Vec2> line_of(const PlottedCurve& curve, const PlotScale& scale) {
  constexpr double step = 2.0;
  std::vector<Vec2> line;
  for (double at = 0.0; at <= scale.size.x; at += step) {
    const double x = scale.x_of(scale.corner.x + at);
    line.emplace_back(x, curve.value(x));
  }
  return line;
}

void draw_line(ImDrawList& draw, const PlotScale& scale, const std::vector<Vec2>& line, ImU32 colour) {
  for (const Vec2& point : line) draw.PathLineTo(pixel(scale.to_pixel(point.x, point.y)));
  draw.PathStroke(colour, 0, 1.8f);
}

/// Of all that is seen between two times.
PlotRange values_of(const PlottedCurve& curve, const std::vector<Vec2>& line, const PlotRange& shown) {
  PlotRange range;
  const auto is_shown = [&](double x) { return x >= shown.low && x <= shown.high; };
  for (const Vec2& point : line) range.add(point.y);
  for (std::size_t i = 0; i < curve.samples.size(); ++i)
    if (is_shown(curve.times[i])) range.add(curve.samples[i]);
  for (const CurveKey& key : curve.keys)
    if (is_shown(key.seconds)) range.add(key.value);
  return range.widened(0.10, 2.0);
}

/// Where the handle of a key's slope stands.
Vec2 handle_of(const PlotScale& scale, const CurveKey& key) {
  const double slope = scale.pixel_slope(key.slope);
  return scale.to_pixel(key.seconds, key.value) + handle_pixels / std::sqrt(1.0 + slope * slope) * Vec2(1.0, slope);
}

void draw_keys(ImDrawList& draw, const PlottedCurve& curve, const PlotScale& scale) {
  constexpr float half = 4.0f;
  for (const CurveKey& key : curve.keys) {
    const ImVec2 at = pixel(scale.to_pixel(key.seconds, key.value));
    if (curve.has_slopes) {
      const ImVec2 handle = pixel(handle_of(scale, key));
      draw.AddLine(at, handle, handle_colour, 1.2f);
      draw.AddCircleFilled(handle, 3.5f, handle_colour);
    }
    draw.AddRectFilled({at.x - half, at.y - half}, {at.x + half, at.y + half}, key_colour, 1.0f);
  }
}

/// How far the samples are from the curve, in a strip of its own.
void draw_residual(ImDrawList& draw, const PlottedCurve& curve, PlotScale scale, float top) {
  PlotRange range;
  for (const double residual : curve.residuals) range.add(residual);
  const double most = std::max({std::abs(range.low), std::abs(range.high), 1e-3});
  scale.y = PlotRange{-most, most}.widened(0.1, 0.0);
  scale.corner.y = top;
  scale.size.y = residual_height;
  draw_ground(draw, scale, "", false);
  draw.PushClipRect(pixel(scale.corner), pixel(scale.corner + scale.size), true);
  for (std::size_t i = 0; i < curve.times.size(); ++i)
    draw.PathLineTo(pixel(scale.to_pixel(curve.times[i], curve.residuals[i])));
  draw.PathStroke(residual_colour, 0, 1.2f);
  draw.PopClipRect();
  draw_caption(draw, scale, "residual");
}

/// The key or handle under the pointer.
std::optional<MotionPanel::Drag> grasped(const PlottedCurve& curve, const PlotScale& scale, const Vec2& pointer) {
  std::optional<MotionPanel::Drag> found;
  double nearest = reach_pixels;
  for (std::size_t i = 0; i < curve.keys.size(); ++i) {
    const double to_key = glm::distance(pointer, scale.to_pixel(curve.keys[i].seconds, curve.keys[i].value));
    const double to_handle = curve.has_slopes ? glm::distance(pointer, handle_of(scale, curve.keys[i])) : INFINITY;
    if (std::min(to_key, to_handle) > nearest) continue;
    nearest = std::min(to_key, to_handle);
    found = MotionPanel::Drag{i, to_handle < to_key, scale, {curve.keys[i].seconds, curve.keys[i].value}};
  }
  return found;
}

/// The wheel zooms round the pointer; out again it shows all.
void take_wheel(const PlotScale& scale, const PlotRange& whole, std::optional<PlotRange>& zoom) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!ImGui::IsItemHovered() || io.MouseWheel == 0.0f) return;
  constexpr double step = 0.8, shortest_share = 0.002;
  const double middle = scale.x_of(io.MousePos.x), factor = std::pow(step, double(io.MouseWheel));
  PlotRange next{middle + (scale.x.low - middle) * factor, middle + (scale.x.high - middle) * factor};
  if (next.length() < shortest_share * whole.length()) return;
  next = {std::max(next.low, whole.low), std::min(next.high, whole.high)};
  zoom = next.length() >= whole.length() * (1.0 - 1e-9) ? std::nullopt : std::optional(next);
}

/// What the pointer does to the curve.
PlotAction take_pointer(const PlottedCurve& curve, const PlotScale& shown, std::optional<MotionPanel::Drag>& drag) {
  const ImGuiIO& io = ImGui::GetIO();
  const Vec2 pointer(io.MousePos.x, io.MousePos.y);
  PlotAction action;
  if (drag && (!ImGui::IsMouseDown(ImGuiMouseButton_Left) || drag->key >= curve.keys.size())) {
    drag.reset();
    action.kind = PlotAction::Kind::released;
    return action;
  }
  if (drag) {
    if (io.MouseDelta.x == 0.0f && io.MouseDelta.y == 0.0f) return action;
    action.key = drag->key;
    action.x = drag->scale.x_of(pointer.x);
    action.value = drag->scale.y_of(pointer.y);
    const double away = std::abs(pointer.x - drag->scale.to_pixel(drag->from.x, drag->from.y).x);
    drag->in_time = drag->in_time || (!drag->slope && (io.KeyShift || away > time_pixels));
    action.in_time = drag->in_time;
    if (io.KeyShift && !drag->slope) action.value = drag->from.y;
    action.kind = drag->slope ? PlotAction::Kind::set_slope : PlotAction::Kind::set_value;
    const Vec2 way = pointer - drag->scale.to_pixel(curve.keys[drag->key].seconds, curve.keys[drag->key].value);
    // A handle stands to the right of its key; to the left of it a slope would jump.
    action.slope = drag->scale.slope_of(way.y / std::max(way.x, 4.0));
    return action;
  }
  if (!ImGui::IsItemHovered()) return action;
  const auto under = grasped(curve, shown, pointer);
  if (under) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  action.x = shown.x_of(pointer.x);
  action.value = shown.y_of(pointer.y);
  if (under && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    action.kind = PlotAction::Kind::remove;
    action.key = under->key;
  } else if (under && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    drag = under;
  } else if (!under && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    action.kind = PlotAction::Kind::add;
  }
  return action;
}

}  // namespace

PlotAction draw_plot(const PlottedCurve& curve, MotionPanel& panel) {
  std::optional<MotionPanel::Drag>& drag = panel.drag;
  const ImVec2 at = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const float below = bottom_margin + (curve.residuals.empty() ? 0.0f : residual_height + gap);
  if (room.x < left_margin + 60.0f || room.y < below + 40.0f) return {};
  PlotScale scale;
  scale.corner = {at.x + left_margin, at.y};
  scale.size = {room.x - left_margin, room.y - below};
  const PlotRange whole = curve.range.widened(0.02, 1e-3);
  const bool fits = panel.zoom && panel.zoom->low >= whole.low && panel.zoom->high <= whole.high;
  if (!fits) panel.zoom.reset();  // another curve
  scale.x = panel.zoom.value_or(whole);
  const std::vector<Vec2> line = line_of(curve, scale);
  scale.y = drag ? drag->scale.y : values_of(curve, line, scale.x);
  ImGui::InvisibleButton("plot", room);
  const PlotAction action = take_pointer(curve, scale, drag);
  take_wheel(scale, whole, panel.zoom);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw_ground(draw, scale, curve.unit, true);
  const ImVec2 low = pixel(scale.corner), high = pixel(scale.corner + scale.size);
  draw.PushClipRect(low, high, true);
  for (const CurveKey& key : curve.keys) {
    const float x = pixel(scale.to_pixel(key.seconds, 0.0)).x;
    draw.AddLine({x, low.y}, {x, high.y}, cut_colour);
  }
  const float now = pixel(scale.to_pixel(curve.now, 0.0)).x;
  draw.AddLine({now, low.y}, {now, high.y}, now_colour);
  for (std::size_t i = 0; i < curve.samples.size(); ++i) {
    const ImVec2 dot = pixel(scale.to_pixel(curve.times[i], curve.samples[i]));
    draw.AddRectFilled({dot.x - 1.5f, dot.y - 1.5f}, {dot.x + 1.5f, dot.y + 1.5f}, dot_colour);
  }
  draw_line(draw, scale, line, curve_colour);
  draw_keys(draw, curve, scale);
  draw.PopClipRect();
  draw_caption(draw, scale, curve.caption);
  if (!curve.residuals.empty()) draw_residual(draw, curve, scale, high.y + bottom_margin + gap);
  return action;
}

}  // namespace sinew
