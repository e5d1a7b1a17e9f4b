#pragma once
/// The main path: scene and frame number in, picture out.

#include "engine/app/stage.h"
#include "engine/render/renderer.h"

namespace sinew {

/// How the scene is looked at: what the command line says over what the scene says.
struct LookOptions {
  PictureSize size;
  int samples = 1;
  std::optional<View> view;     ///< in place of the scene's whole camera
  std::optional<double> orbit;  ///< degrees, counter-clockwise seen from above
  std::optional<Shading> shading;
  std::string joint;  ///< whose weights are shown; empty: the scene's
  std::optional<bool> shadows, floor;
  std::optional<Colour> background;
  WireMode wire = WireMode::none;
  bool for_window = false;  ///< RendererOptions::for_window
};

struct CameraPlace {
  ViewDirection direction;
  Rays rays = Rays::from_eye;
  std::optional<Vec3> target;
  std::optional<double> distance;
};

/// Makes the pictures of a stage. Stage and device must outlive it.
class FrameMaker {
 public:
  /// Uploads every character. What could not be shown as the files ask is named in `problems`.
  static Result<FrameMaker> create(Device& device, const Stage& stage, const SceneOptions& scene,
                                   const LookOptions& look, std::vector<std::string>& problems);

  /// The picture at a frame: a function of the stage and the number alone.
  Result<Picture> picture(int frame);
  /// The same seen otherwise.
  Result<Picture> picture(int frame, const Shot& shot);

  /// The steps of picture().
  std::vector<CharacterState> pose(int frame) const;
  Result<void> upload(const std::vector<CharacterState>& states);
  /// `orbit`: degrees added to the camera's.
  Shot shot(int frame, double orbit = 0.0) const;
  Renderer& renderer() { return renderer_; }

  /// Where the scene wants the camera; what it leaves open is filled in when the box of all that is shown is framed.
  CameraPlace camera_place(int frame) const;
  const Bounds& bounds() const { return bounds_; }

  // For windows.
  /// As picture(), into the renderer's own image. `states`: pose(frame).
  Result<void> draw_for_window(int frame, const std::vector<CharacterState>& states);
  Result<void> resize(const PictureSize& size);
  /// Takes the bounds anew after the stage's motions or poses have changed. Its meshes and materials, the
  /// muscles (follow_muscles) and which joint's weights are shown, must be those that the maker was created with.
  void follow_stage();
  /// Takes the stage's muscles anew, which are as many as before. Fails as GpuDeformer::set_muscles does.
  Result<void> follow_muscles();

 private:
  Viewpoint viewpoint(int frame, double orbit) const;
  FrameMaker(Renderer renderer, const Stage& stage, const LookOptions& look, const Bounds& bounds, double floor);

  Renderer renderer_;
  const Stage* stage_;
  LookOptions look_;
  Bounds bounds_;
  double floor_ = 0.0;  ///< height of the rest pose's lowest point
};

}  // namespace sinew
