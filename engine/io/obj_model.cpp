#include "engine/io/obj_model.h"

#include "engine/core/text.h"
#include "engine/io/gltf_read.h"
#include "engine/io/gltf_triangles.h"
#include "engine/io/obj_read.h"

namespace sinew {

Result<Model> obj_model(const std::filesystem::path& file) {
  auto read = read_obj(file);
  if (!read) return pass_on(std::move(read));
  if (read->polygons.empty()) return bad_input("{}: no faces", file.string());
  Primitive primitive;
  primitive.positions = std::move(read->positions);
  for (const auto& polygon : read->polygons)
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
      primitive.indices.insert(primitive.indices.end(), {polygon[0], polygon[i], polygon[i + 1]});
  primitive.normals = gltf::smooth_normals(primitive.positions, primitive.indices);
  Mesh mesh;
  mesh.name = file.stem().string();
  mesh.primitives.push_back(std::move(primitive));
  Model model = single_mesh_model(std::move(mesh));
  model.file = file.string();
  return model;
}

Result<Model> read_mesh_model(const std::filesystem::path& file) {
  return lower(file.extension().string()) == ".obj" ? obj_model(file) : read_gltf(file);
}

}  // namespace sinew
