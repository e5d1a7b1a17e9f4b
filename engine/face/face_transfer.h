#pragma once
/// The face of the head from drawing rules laid on any mesh. engine/definitions.md 15.

#include <string>
#include <vector>

#include "engine/face/face_mesh.h"
#include "engine/face/head.h"

namespace sinew {

/// A mesh with a face: its places as a head, whose positions are in drawing units and whose triangles are all skin;
/// `place_of` and `to_mesh` lead back to the mesh's own vertices.
struct TransferredFace {
  Head head;
  std::vector<std::uint32_t> place_of;  ///< [vertices of the mesh]
  Similarity to_mesh;                   ///< from drawing units to the mesh's bind pose
  std::vector<std::string> notes;       ///< what the mesh lacks, for people

  FaceGuides guides;  ///< heights of the landmarks that were given

  /// The face in the order of the mesh's vertices.
  FaceRig rig() const { return picked_face(head.face, place_of); }
};

/// `landmarks`: in the space of `mesh.positions`. `name`: for messages. Fails as face_mesh does, and where the
/// landmarks do not lie on the mesh.
Result<TransferredFace> transfer_face(const Head& from, const CharacterMesh& mesh, const Landmarks& landmarks,
                                      const std::string& name);

/// The head that faces are taken from: the adult.
const Head& template_head();

}  // namespace sinew
