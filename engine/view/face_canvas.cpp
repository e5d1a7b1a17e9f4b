#include "engine/view/face_canvas.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

constexpr ImU32 paper = IM_COL32(233, 222, 205, 255), line = IM_COL32(70, 52, 46, 255),
                lips = IM_COL32(196, 110, 104, 255), mouth = IM_COL32(92, 36, 40, 255), white = IM_COL32_WHITE,
                iris = IM_COL32(74, 104, 128, 255), hair = IM_COL32(92, 66, 52, 255);

void stroke(ImDrawList& draw, const std::vector<ImVec2>& points, ImU32 colour, float width, bool closed = false) {
  draw.AddPolyline(points.data(), static_cast<int>(points.size()), colour,
                   closed ? ImDrawFlags_Closed : ImDrawFlags_None, width);
}

/// Fills the area between two lines that run the same way.
void fill_between(ImDrawList& draw, const std::vector<ImVec2>& upper, const std::vector<ImVec2>& lower, ImU32 colour) {
  // Soft edges of neighbouring pieces would show as stripes.
  const ImDrawListFlags flags = draw.Flags;
  draw.Flags &= ~ImDrawListFlags_AntiAliasedFill;
  for (std::size_t i = 0; i + 1 < std::min(upper.size(), lower.size()); ++i)
    draw.AddQuadFilled(upper[i], upper[i + 1], lower[i + 1], lower[i], colour);
  draw.Flags = flags;
}

void draw_eye(ImDrawList& draw, const FaceSheet& sheet, const FacePicture::Eye& eye) {
  const std::vector<ImVec2> upper = sheet.at(eye.upper), lower = sheet.at(eye.lower);
  fill_between(draw, upper, lower, white);
  // The iris between the lids.
  const ImVec2 centre = sheet.at(eye.iris);
  const float r = sheet.scale * static_cast<float>(eye.iris_radius);
  const auto lid_at = [](const std::vector<ImVec2>& lid, float x) {
    for (std::size_t i = 0; i + 1 < lid.size(); ++i)
      if (x <= lid[i + 1].x) {
        const float t = std::clamp((x - lid[i].x) / std::max(lid[i + 1].x - lid[i].x, 1e-3f), 0.0f, 1.0f);
        return lid[i].y + t * (lid[i + 1].y - lid[i].y);
      }
    return lid.back().y;
  };
  std::vector<ImVec2> top, bottom;
  for (int i = -8; i <= 8; ++i) {
    const float x = centre.x + r * static_cast<float>(i) / 8.0f,
                half = std::sqrt(std::max(0.0f, r * r - (x - centre.x) * (x - centre.x)));
    const float over = lid_at(upper, x), under = std::max(lid_at(lower, x), over);
    top.emplace_back(x, std::clamp(centre.y - half, over, under));
    bottom.emplace_back(x, std::clamp(centre.y + half, over, under));
  }
  fill_between(draw, top, bottom, iris);
  stroke(draw, lower, line, 1.2f);
  stroke(draw, upper, line, 2.2f);
}

}  // namespace

void draw_face_lines(ImDrawList& draw, const FaceSheet& sheet, const FacePicture& picture) {
  const std::vector<ImVec2> outline = sheet.at(picture.outline);
  const ImVec2 high_left(outline.front().x, sheet.corner.y), high_right(outline.back().x, sheet.corner.y);
  // The outline is convex, with the open top closed above the picture's edge.
  std::vector<ImVec2> skin = outline;
  skin.push_back(high_right);
  skin.push_back(high_left);
  draw.AddConvexPolyFilled(skin.data(), static_cast<int>(skin.size()), paper);
  stroke(draw, outline, line, 1.5f);
  for (const FacePicture::Eye& eye : picture.eyes) draw_eye(draw, sheet, eye);
  for (const FacePicture::Brow& brow : picture.brows) {
    const std::vector<ImVec2> one = sheet.at(brow.one), other = sheet.at(brow.other);
    fill_between(draw, one, other, hair);
    stroke(draw, one, hair, 1.5f);
    stroke(draw, other, hair, 1.5f);
  }
  stroke(draw, sheet.at(picture.nose), line, 1.3f);
  const std::vector<ImVec2> outer = sheet.at(picture.lip_outer), inner = sheet.at(picture.lip_inner);
  const auto halves = [](const std::vector<ImVec2>& closed) {
    const auto half = static_cast<std::ptrdiff_t>(closed.size() / 2);
    std::pair<std::vector<ImVec2>, std::vector<ImVec2>> out{{closed.begin(), closed.begin() + half + 1},
                                                            {closed.begin() + half, closed.end()}};
    out.second.push_back(closed.front());
    std::ranges::reverse(out.second);
    return out;
  };
  const auto [outer_top, outer_bottom] = halves(outer);
  const auto [inner_top, inner_bottom] = halves(inner);
  fill_between(draw, outer_top, outer_bottom, lips);
  fill_between(draw, inner_top, inner_bottom, mouth);
  stroke(draw, outer, line, 1.0f, true);
  stroke(draw, inner, line, 1.2f, true);
}

}  // namespace sinew
