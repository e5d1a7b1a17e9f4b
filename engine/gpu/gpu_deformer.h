#pragma once
/// The compute pass that deforms a character: the device's twin of engine/deform.

#include <memory>
#include <span>

#include "engine/deform/reference.h"
#include "engine/gpu/device.h"
#include "engine/gpu/packing.h"

namespace sinew {

/// How the shader reads its input.
enum class BufferLayout {
  automatic,  ///< texel buffers on a CPU device whose limits allow it, else storage buffers
  texel,
  storage,
};

struct GpuDeformerOptions {
  Deformer deformer = Deformer::ssd;
  BulgeMode bulge = BulgeMode::on;
  BufferLayout layout = BufferLayout::automatic;
  std::size_t largest_range = 0;  ///< bytes that one binding may span; 0: what the device allows
  bool bare = false;              ///< for benchmarks: a plain 4-influence SSD kernel of the same vertex layout
};

/// What changes from frame to frame.
struct GpuDeformState {
  std::span<const Mat34> palette;         ///< [mesh.palette] F_i, world space
  std::span<const double> morph_weights;  ///< [mesh.morph_slots]
  std::span<const double> activations;    ///< [muscles] delta of engine/definitions.md 6
  const FaceState* face = nullptr;        ///< of a mesh that has a face; null: at rest
};

/// Skinned vertices on the device: position and bulge height, normal. Two words of 16 bytes a vertex.
class GpuDeformer {
 public:
  /// Uploads the character. Fails as bad_input where it is too large for the device, as device_failed where the device
  /// has no memory for it. The device must outlive the deformer.
  static Result<GpuDeformer> create(Device& device, const CharacterMesh& mesh, const RestShape& rest,
                                    std::span<const PlacedMuscle> muscles, const GpuDeformerOptions& options,
                                    std::span<const RigidDuplicate> duplicates = {});

  GpuDeformer(GpuDeformer&&) noexcept;
  GpuDeformer& operator=(GpuDeformer&&) noexcept;
  ~GpuDeformer();

  std::size_t vertices() const;
  /// Number of dispatches that a frame takes: 1 but for characters beyond the device's range limit.
  std::size_t dispatches() const;
  BufferLayout layout() const;

  /// Another shape of the same character: positions, normals, morph deltas and face of `mesh`, whose vertices,
  /// influences and kinds of details are those it was created with. Must not run while the device still works on the
  /// last frame. Fails as bad_input where the details have outgrown their buffer.
  Result<void> set_mesh(const CharacterMesh& mesh, const RestShape& rest);

  /// The same muscles with other numbers, at other places: as many as it was created with, on `mesh`, which is the one
  /// that it shows. Must not run while the device still works on the last frame. Fails as bad_input where their number
  /// is another or a vertex lies in too many regions (pack_character), as device_failed where there is no memory; then
  /// nothing has changed.
  Result<void> set_muscles(const CharacterMesh& mesh, const RestShape& rest, std::span<const PlacedMuscle> muscles);

  /// Writes a frame's palette, weights and activations where the next dispatch reads them. Must not run while the
  /// device still works on the last frame.
  void set_state(const GpuDeformState& state);

  /// Deforms in a submit of its own and waits.
  Result<void> run();

  /// Copies the deformed vertices to the host. [vertices * layout::words_per_output]
  Result<std::vector<Vec4f>> read_back();

  /// Copies the deformed tangents to the host. [vertices], or empty: the mesh has none.
  Result<std::vector<Vec4f>> read_back_tangents();

  struct Impl;
  Impl& impl() { return *impl_; }
  const Impl& impl() const { return *impl_; }

 private:
  explicit GpuDeformer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace sinew
