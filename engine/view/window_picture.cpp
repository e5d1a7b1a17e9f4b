#include "engine/view/window_picture.h"

#include <cmath>

#include "engine/app/comparison.h"
#include "engine/app/figure.h"
#include "engine/core/files.h"
#include "engine/io/png.h"
#include "engine/render/renderer_image.h"

namespace sinew {

void join_sides(Picture& left, const Picture& right, double divider) {
  const int from = static_cast<int>(std::lround(std::clamp(divider, 0.0, 1.0) * left.width));
  for (int y = 0; y < left.height; ++y) {
    const auto row = std::ptrdiff_t{4} * left.width * y;
    std::copy(right.rgba.begin() + row + std::ptrdiff_t{4} * from,
              right.rgba.begin() + row + std::ptrdiff_t{4} * left.width,
              left.rgba.begin() + row + std::ptrdiff_t{4} * from);
  }
}

Result<WindowPicture> WindowPicture::create(Device& device, const Document& document, const LookOptions& look,
                                            std::vector<std::string>& problems) {
  const Look& scene = document.scene().look;
  const FigureLook figure = figure_look({}, scene);
  LookOptions wired = look;
  wired.wire = figure.overlay.wire;
  SceneOptions left = document.options();
  const bool compares = scene.compare != CompareWith::none;
  std::array<ComparedSide, 2> sides;
  if (compares) {
    sides = compared_sides(scene.compare, document.options(), figure.overlay);
    left = sides[0].scene;
  }
  auto maker = FrameMaker::create(device, document.stage(), left, wired, problems);
  if (!maker) return pass_on(std::move(maker));
  WindowPicture out(device, document, look, std::move(*maker));
  if (compares) {
    LookOptions other = look;
    other.wire = sides[1].overlay.wire;
    std::vector<std::string> repeated;
    auto made = FrameMaker::create(device, document.stage(), sides[1].scene, other, repeated);
    if (!made) return pass_on(std::move(made));
    out.other_ = std::move(*made);
    out.labels_ = {sides[0].label, sides[1].label};
    // Which overlays there are may change while the sides stay.
    if (scene.compare == CompareWith::overlay) out.labels_ = {"with overlays", "without"};
  }
  if (auto font = Font::find()) out.font_ = std::move(*font);
  return out;
}

Result<Picture> WindowPicture::side(FrameMaker& maker, const SceneOptions& scene, const OverlayOptions& overlay,
                                    int frame, const ViewExtras& extras) const {
  auto picture = maker.picture(frame);
  if (!picture) return picture;
  std::vector<MuscleNumber> also;
  if (extras.muscle) also.push_back(*extras.muscle);
  const OverlayContent content = overlay_content(document_->stage(), scene, overlay, frame, also);
  if (auto ok = draw_overlay(*picture, font_ ? &*font_ : nullptr, maker.shot(frame).viewpoint, content); !ok)
    return pass_on(std::move(ok));
  return picture;
}

Result<void> WindowPicture::draw(int frame, const std::vector<CharacterState>& states, const ViewExtras& extras) {
  const OverlayOptions overlay = figure_look({}, document_->scene().look).overlay;
  if (!other_ && !overlay.painted() && !extras.muscle) return maker_.draw_for_window(frame, states);
  std::array<ComparedSide, 2> sides{ComparedSide{document_->options(), overlay, ""}, {}};
  if (other_) sides = compared_sides(document_->scene().look.compare, document_->options(), overlay);
  auto picture = side(maker_, sides[0].scene, sides[0].overlay, frame, extras);
  if (!picture) return pass_on(std::move(picture));
  if (other_) {
    const auto right = side(*other_, sides[1].scene, sides[1].overlay, frame, extras);
    if (!right) return tl::unexpected<Error>(right.error());
    join_sides(*picture, *right, extras.divider);
  }
  return put_picture(device_->vulkan(), maker_.renderer(), *picture);
}

Result<std::string> WindowPicture::save_photo(int frame, const PictureSize& size,
                                              const std::filesystem::path& scene_file) {
  const FigureLook figure = figure_look({}, document_->scene().look);
  LookOptions look = look_;
  look.size = size;
  std::vector<std::string> problems;
  auto made = FigureMaker::create(*device_, document_->stage(), document_->options(), look, figure, problems);
  if (!made) return pass_on(std::move(made));
  const auto picture = made->picture(frame, {frame});
  if (!picture) return tl::unexpected<Error>(picture.error());
  const std::filesystem::path file =
      scene_file.parent_path() / fmt::format("{}_{:04}.png", scene_file.stem().string(), frame);
  const auto png = encode_png(picture->rgba, picture->width, picture->height, {}, false);
  if (!png) return tl::unexpected<Error>(png.error());
  if (auto ok = write_file(file, *png); !ok) return pass_on(std::move(ok));
  return file.string();
}

void WindowPicture::follow_stage() {
  maker_.follow_stage();
  if (other_) other_->follow_stage();
}

Result<void> WindowPicture::follow_muscles() {
  if (other_)
    if (auto ok = other_->follow_muscles(); !ok) return ok;
  return maker_.follow_muscles();
}

Result<void> WindowPicture::resize(const PictureSize& size) {
  look_.size = size;
  if (other_)
    if (auto ok = other_->resize(size); !ok) return ok;
  return maker_.resize(size);
}

}  // namespace sinew
