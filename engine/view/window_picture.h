#pragma once
/// The picture behind the panels: what `render` makes of the scene, a comparison's sides on each other with a divider
/// between them.

#include "engine/app/frame.h"
#include "engine/app/overlay_content.h"
#include "engine/render/text.h"
#include "engine/view/document.h"

namespace sinew {

/// What is seen beyond the scene.
struct ViewExtras {
  std::optional<MuscleNumber> muscle;  ///< whose region is shown
  double divider = 0.5;                ///< of a comparison: share of the width that the left side has
  bool operator==(const ViewExtras&) const = default;
};

class WindowPicture {
 public:
  /// Device and document must outlive it. Fails as FrameMaker::create does.
  static Result<WindowPicture> create(Device& device, const Document& document, const LookOptions& look,
                                      std::vector<std::string>& problems);

  FrameMaker& maker() { return maker_; }
  /// The sides' names where the scene compares; else empty.
  const std::string& left_label() const { return labels_[0]; }
  const std::string& right_label() const { return labels_[1]; }

  /// Draws into the image that the window shows. `states`: maker().pose(frame).
  Result<void> draw(int frame, const std::vector<CharacterState>& states, const ViewExtras& extras);
  /// Writes the picture that `render` makes of the scene at this frame in this size, beside the scene's file and called
  /// after it and the frame; returns its name. Fails as cannot_write.
  Result<std::string> save_photo(int frame, const PictureSize& size, const std::filesystem::path& scene_file);
  void follow_stage();
  /// Shows the muscles' numbers as the document has them now. Fails as FrameMaker::follow_muscles does.
  Result<void> follow_muscles();
  Result<void> resize(const PictureSize& size);

 private:
  WindowPicture(Device& device, const Document& document, const LookOptions& look, FrameMaker maker)
      : device_(&device), document_(&document), look_(look), maker_(std::move(maker)) {}

  Result<Picture> side(FrameMaker& maker, const SceneOptions& scene, const OverlayOptions& overlay, int frame,
                       const ViewExtras& extras) const;

  Device* device_;
  const Document* document_;
  LookOptions look_;
  FrameMaker maker_;
  std::optional<FrameMaker> other_;  ///< of a comparison's right side, where it has a surface of its own
  std::array<std::string, 2> labels_;
  std::optional<Font> font_;
};

/// `left` up to the divider, `right` beyond it; both of one size.
void join_sides(Picture& left, const Picture& right, double divider);

}  // namespace sinew
