#pragma once
/// Pictures of deformed characters. Vulkan types stay behind this header.

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "engine/gpu/gpu_deformer.h"
#include "engine/model/picture.h"
#include "engine/model/scene.h"
#include "engine/render/viewpoint.h"
#include "engine/render/wire_mode.h"

namespace sinew {

struct Target;

struct RendererOptions {
  int width = 1280, height = 720;
  int samples = 1;  ///< 1 or 4
  WireMode wire = WireMode::none;
  bool for_window = false;  ///< the picture lies on the device as most windows have it, blue first
};

/// One frame's look at the scene.
struct Shot {
  Viewpoint viewpoint;
  Shading shading = Shading::lit;
  std::array<float, 4> background{0.847f, 0.847f, 0.847f, 1.0f};  ///< sRGB and alpha, 0 to 1
  double largest_bulge = 0.0;   ///< height that Shading::bulge shows in full red, world units
  Bounds scene;                 ///< box of all that is shown over the whole range: what shadows are drawn for
  bool shadows = false;         ///< of the key light; Shading::lit and flat only
  std::optional<double> floor;  ///< height of the floor that shows shadows; likewise
  double ground = 0.0;          ///< where it would be if it is not shown: surfaces look the same either way
};

/// What a character looks like, besides its shape.
struct CharacterLook {
  std::span<const double> weights;  ///< [mesh.vertices] 0 to 1, what Shading::weights shows; or empty
};

/// Draws any number of characters into one picture. A frame is set_state() of every character, then draw().
class Renderer {
 public:
  /// Fails as bad_input where the device cannot make pictures of this size or sample count, as device_failed where
  /// there is no memory. The device must outlive the renderer.
  static Result<Renderer> create(Device& device, const RendererOptions& options);

  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// Uploads a character with its materials and textures; its number is the order of the calls. A texture that cannot
  /// be decoded is shown as white and named in `problems`. With Deformer::rigid each triangle follows one bone.
  Result<void> add_character(const Model& model, const CharacterMesh& mesh, const RestShape& rest,
                             std::span<const PlacedMuscle> muscles, const GpuDeformerOptions& options,
                             const CharacterLook& look, std::vector<std::string>& problems);

  GpuDeformer& deformer(std::size_t character);

  /// Deforms every character, draws and reads back, in one submit.
  Result<Picture> draw(const Shot& shot);

  /// Deforms every character and draws, in one submit, into the image that a window shows (render/renderer_image.h).
  Result<void> draw_for_window(const Shot& shot);
  /// Draws pictures of another size from now on. Fails as create() does, and then stays as it is.
  Result<void> resize(int width, int height);

  /// The same in separate submits, for benchmarks.
  Result<void> deform();
  Result<void> draw_only(const Shot& shot);
  Result<void> copy_only();
  Picture picture() const;

 private:
  struct Impl;
  friend const Target& picture_target(const Renderer& renderer);
  explicit Renderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace sinew
