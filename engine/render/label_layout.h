#pragma once
/// Places for labels beside what they name: near it where there is room, farther off with a leader line where there is
/// not, nowhere where that fails too. Greedy: who asks first is served first.

#include <optional>
#include <span>
#include <vector>

#include "engine/render/canvas.h"

namespace sinew {

/// What a label asks for; all in pixels.
struct LabelRequest {
  Vec2 anchor{0.0};        ///< what the label names
  Vec2 size{0.0};          ///< of the label's box
  Vec2 away{1.0, 0.0};     ///< the side it would best stand on, any length
  double clearance = 6.0;  ///< from the anchor to the box when it stands near
  double dot = 0.0;        ///< radius of the mark at the anchor, where a leader begins
  bool may_cover = false;  ///< may lie over lines (but not over points or labels) where there is no other room
};

struct PlacedLabel {
  Rect box;
  bool leader = false;  ///< too far off to be understood without a line
  Vec2 leader_from{0.0}, leader_to{0.0};
};

class LabelLayout {
 public:
  LabelLayout(int width, int height);

  /// No label will lie over this box, or, while there is other room, over this line.
  void avoid(const Rect& box) { boxes_.push_back(box); }
  void avoid(const Vec2& from, const Vec2& to) { lines_.push_back({from, to}); }

  /// A place within the picture that overlaps no label placed before. It is taken from then on, and its leader too.
  std::optional<PlacedLabel> place(const LabelRequest& request);

 private:
  struct Line {
    Vec2 from{0.0}, to{0.0};
  };
  bool is_free(const PlacedLabel& label, bool over_lines) const;

  Rect picture_;
  std::vector<Rect> boxes_, labels_;
  std::vector<Line> lines_, leaders_;
};

/// The rising numbers that are nearest to `wanted` (rising) with neighbours at least `gap` apart: least squares, by
/// pooling adjacent violators (Ayer et al. 1955).
std::vector<double> spread_apart(std::span<const double> wanted, double gap);

/// True where the segment and the box share a point.
bool meets(const Vec2& from, const Vec2& to, const Rect& box);

}  // namespace sinew
