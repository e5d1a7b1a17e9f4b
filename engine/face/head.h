#pragma once
/// A head from drawing rules: skin, eyes, brows, teeth and tongue, with the regions that move them.
/// engine/definitions.md 15; Loomis 1956; Yen 1990.

#include <map>
#include <memory>

#include "engine/face/head_measures.h"
#include "engine/face/head_parts.h"
#include "engine/face/head_skin.h"
#include "engine/model/face.h"
#include "engine/model/scene.h"

namespace sinew {

struct Head {
  HeadMeasures measures;
  std::vector<Vec3> positions;            ///< [vertices] drawing units; front +z, the head's left +x, chin at y = 0
  std::vector<Vec3> normals;              ///< [vertices]
  std::vector<Vec2> texture_coordinates;  ///< [vertices]
  std::vector<double> blush;              ///< [vertices] 0 to 1: where the skin is redder
  std::vector<double> gloom;              ///< [vertices] 0 to 1: how deep in the mouth, where little light comes
  std::vector<HeadTriangle> triangles;    ///< the same for every head of a level
  std::size_t skin_vertices = 0;          ///< the skin's stand first
  std::vector<std::uint32_t> mirror;      ///< [vertices] the same place on the other side
  FaceRig face;
  std::map<std::string, std::uint32_t> landmarks;  ///< crown, hairLine, brow ...: vertices
  std::map<std::string, std::uint32_t> marks;      ///< the vertex of each of landmark_names()

  /// Vertices of upper and lower lip that lie on each other when the mouth is shut, from the middle to both corners.
  std::vector<std::array<std::uint32_t, 2>> lip_line;

  double metres() const { return measures.height / head_units; }  ///< a drawing unit's length
};

/// The lines that a head of these measures is drawn by.
FaceGuides head_guides(const HeadMeasures& measures);

/// The parts of heads that do not depend on measures, for heads of one level of subdivision.
class HeadMaker {
 public:
  /// `level` from 0 to most_head_level.
  explicit HeadMaker(int level = default_head_level);
  ~HeadMaker();
  HeadMaker(HeadMaker&&) noexcept;

  /// Fails as check_measures does.
  Result<Head> head(const HeadMeasures& measures) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The whole face in this state: positions in drawing units.
std::vector<Vec3> posed_positions(const Head& head, const FaceChannels& channels);

/// Unit normals of the head's triangles at these positions, corners weighted by their angles; symmetric where the
/// positions are.
std::vector<Vec3> head_normals(const Head& head, const std::vector<Vec3>& positions);

}  // namespace sinew
