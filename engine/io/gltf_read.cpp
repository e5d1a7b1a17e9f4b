#include "engine/io/gltf_read.h"

#include <new>

#include "engine/io/gltf_clip.h"
#include "engine/io/gltf_document.h"
#include "engine/io/gltf_image.h"
#include "engine/io/gltf_material.h"
#include "engine/io/gltf_mesh.h"
#include "engine/io/gltf_scene.h"
#include "engine/io/gltf_vrm.h"

namespace sinew {
namespace {

Result<Model> read_document(gltf::Document& document) {
  Model model;
  auto nodes = gltf::read_nodes(document);
  if (!nodes) return pass_on(std::move(nodes));
  model.nodes = std::move(*nodes);
  auto roots = gltf::read_roots(document, model.nodes);
  if (!roots) return pass_on(std::move(roots));
  model.roots = std::move(*roots);
  auto skins = gltf::read_skins(document, model.nodes);
  if (!skins) return pass_on(std::move(skins));
  model.skins = std::move(*skins);
  auto materials = gltf::read_materials(document);
  auto meshes = gltf::read_meshes(document, materials);
  if (!meshes) return pass_on(std::move(meshes));
  model.materials = std::move(materials.materials);
  model.meshes = std::move(*meshes);
  if (auto matched = gltf::match_nodes_with_meshes(document, model); !matched) return pass_on(std::move(matched));
  auto clips = gltf::read_clips(document, model.nodes, model.meshes);
  if (!clips) return pass_on(std::move(clips));
  model.clips = std::move(*clips);
  auto images = gltf::read_images(document);
  if (!images) return pass_on(std::move(images));
  model.images = std::move(*images);
  model.vrm_bones = gltf::read_vrm_bones(document);
  document.close_problems();
  model.problems = std::move(document.problems);
  return model;
}

Result<Model> read_content(const std::filesystem::path& file, Bytes bytes) {
  auto document = gltf::open_document(file, std::move(bytes));
  if (!document) return pass_on(std::move(document));
  return read_document(*document);
}

}  // namespace

Result<Model> read_gltf(const std::filesystem::path& file) {
  auto bytes = read_file(file, gltf::largest_input);
  if (!bytes) return pass_on(std::move(bytes));
  return read_gltf(file, std::move(*bytes));
}

Result<Model> read_gltf(const std::filesystem::path& file, Bytes bytes) {
  const std::string name = file.string();
  Result<Model> model;
  try {
    model = read_content(file, std::move(bytes));
  } catch (const std::bad_alloc&) {
    return bad_input("{}: there is not enough memory to read it", name);
  }
  if (!model) {
    Error error = std::move(model.error());
    if (!error.message.starts_with(name)) error.message = fmt::format("{}: {}", name, error.message);
    return tl::unexpected(std::move(error));
  }
  model->file = name;
  return model;
}

}  // namespace sinew
