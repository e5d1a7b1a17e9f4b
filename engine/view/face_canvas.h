#pragma once
/// The face's picture drawn on a panel. ImGui's calls inside.

#include <imgui.h>

#include "engine/view/face_picture.h"

namespace sinew {

/// From drawing units to pixels.
struct FaceSheet {
  ImVec2 corner;  ///< upper left
  float scale;

  ImVec2 at(const Vec2& p) const {
    return {corner.x + scale * static_cast<float>(p.x - face_picture_low.x),
            corner.y + scale * static_cast<float>(face_picture_high.y - p.y)};
  }
  std::vector<ImVec2> at(const std::vector<Vec2>& points) const {
    std::vector<ImVec2> out;
    for (const Vec2& p : points) out.push_back(at(p));
    return out;
  }
};

void draw_face_lines(ImDrawList& draw, const FaceSheet& sheet, const FacePicture& picture);

}  // namespace sinew
