#include "engine/io/mesh_read.h"

#include "engine/core/text.h"
#include "engine/io/gltf_read.h"
#include "engine/io/gltf_triangles.h"
#include "engine/io/obj_read.h"
#include "engine/io/ply_read.h"

namespace sinew {
namespace {

bool ends_in(const std::filesystem::path& file, std::string_view extension) {
  return lower(file.extension().string()) == extension;
}

}  // namespace

bool is_polygon_file(const std::filesystem::path& file) { return ends_in(file, ".obj") || ends_in(file, ".ply"); }

Result<Model> read_mesh(const std::filesystem::path& file) {
  if (!is_polygon_file(file)) return read_gltf(file);
  auto polygons = ends_in(file, ".obj") ? read_obj(file) : read_ply(file);
  if (!polygons) return pass_on(std::move(polygons));
  if (polygons->positions.empty()) return bad_input("{}: has no vertices", file.string());
  Primitive primitive;
  primitive.positions = std::move(polygons->positions);
  for (const std::vector<std::uint32_t>& polygon : polygons->polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i)
      primitive.indices.insert(primitive.indices.end(), {polygon[0], polygon[i - 1], polygon[i]});
  primitive.normals = gltf::smooth_normals(primitive.positions, primitive.indices);
  Model model = single_mesh_model({file.stem().string(), {std::move(primitive)}, {}});
  model.file = file.string();
  return model;
}

}  // namespace sinew
