#include "engine/face/head_model.h"

#include <array>

namespace sinew {
namespace {

struct Look {
  const char* name;
  Vec3 colour;  ///< linear
  double roughness;
};

constexpr std::array<Look, head_materials> looks = {{{"skin", {0.70, 0.42, 0.31}, 0.55},
                                                     {"lips", {0.52, 0.17, 0.14}, 0.40},
                                                     {"mouth", {0.13, 0.015, 0.015}, 0.80},
                                                     {"nostrils", {0.16, 0.05, 0.035}, 0.90},
                                                     {"lashes", {0.035, 0.018, 0.012}, 0.80},
                                                     {"sclera", {0.86, 0.86, 0.83}, 0.20},
                                                     {"limbus", {0.012, 0.030, 0.055}, 0.15},
                                                     {"iris", {0.055, 0.19, 0.34}, 0.15},
                                                     {"pupil", {0.004, 0.004, 0.005}, 0.10},
                                                     {"brows", {0.045, 0.020, 0.010}, 0.80},
                                                     {"teeth", {0.86, 0.82, 0.72}, 0.45},
                                                     {"gums", {0.45, 0.11, 0.11}, 0.60},
                                                     {"tongue", {0.50, 0.10, 0.10}, 0.50}}};
/// Factor of the skin's colour where it blushes most.
constexpr Vec3 blush_colour{1.0, 0.62, 0.58};
/// Factor of the colours in the mouth where it is darkest.
constexpr Vec3 gloom_colour{0.16, 0.08, 0.08};

/// The brows of an infant.
constexpr Vec3 downy_brow{0.30, 0.15, 0.08};

bool lies_inside(HeadMaterial material) {
  return material == HeadMaterial::teeth || material == HeadMaterial::gum || material == HeadMaterial::tongue;
}

/// The vertices of one material, in the order of their first use.
struct MaterialPart {
  std::vector<std::uint32_t> vertices;  ///< of the head
  std::vector<std::uint32_t> indices;   ///< into `vertices`
};

std::array<MaterialPart, head_materials> parts_of(const Head& head) {
  std::array<MaterialPart, head_materials> out;
  constexpr std::uint32_t none = ~0u;
  std::array<std::vector<std::uint32_t>, head_materials> place;
  for (auto& list : place) list.assign(head.positions.size(), none);
  for (const HeadTriangle& t : head.triangles) {
    const auto m = static_cast<std::size_t>(t.material);
    for (const std::uint32_t v : t.corners) {
      if (place[m][v] == none) {
        place[m][v] = static_cast<std::uint32_t>(out[m].vertices.size());
        out[m].vertices.push_back(v);
      }
      out[m].indices.push_back(place[m][v]);
    }
  }
  return out;
}

MorphTarget target_of(const HeadShape& shape, std::span<const Vec3> positions, std::span<const Vec3> normals,
                      const MaterialPart& part, double metres) {
  // Below a tenth of a micron nothing has moved; zeros can be left out of the file.
  constexpr double still = 1e-7, unturned = 1e-5;
  MorphTarget out{shape.name, {}, {}};
  for (const std::uint32_t v : part.vertices) {
    const Vec3 move = metres * (shape.positions[v] - positions[v]), turn = shape.normals[v] - normals[v];
    out.positions.push_back(glm::length(move) > still ? move : Vec3(0.0));
    out.normals.push_back(glm::length(turn) > unturned ? turn : Vec3(0.0));
  }
  return out;
}

}  // namespace

Model head_model(const Head& head, const HeadShape* base, std::span<const HeadShape> shapes) {
  const std::vector<Vec3>& positions = base ? base->positions : head.positions;
  const std::vector<Vec3>& normals = base ? base->normals : head.normals;
  const double metres = head.metres();
  std::vector<Material> materials;
  Mesh mesh;
  mesh.name = "head";
  const auto parts = parts_of(head);
  for (std::size_t m = 0; m < head_materials; ++m) {
    Primitive primitive;
    const auto material = static_cast<HeadMaterial>(m);
    for (const std::uint32_t v : parts[m].vertices) {
      primitive.positions.push_back(metres * positions[v]);
      primitive.normals.push_back(normals[v]);
      primitive.texture_coordinates.push_back(head.texture_coordinates[v]);
      if (material == HeadMaterial::skin)
        primitive.colours.emplace_back(glm::mix(Vec3(1.0), blush_colour, head.blush[v]), 1.0);
      if (lies_inside(material)) primitive.colours.emplace_back(glm::mix(Vec3(1.0), gloom_colour, head.gloom[v]), 1.0);
    }
    primitive.indices = parts[m].indices;
    for (const HeadShape& shape : shapes)
      primitive.morph_targets.push_back(target_of(shape, positions, normals, parts[m], metres));
    primitive.material = static_cast<int>(m);
    mesh.primitives.push_back(std::move(primitive));
    Material& look = materials.emplace_back();
    look.name = looks[m].name;
    look.base_colour =
        Vec4(material == HeadMaterial::brow ? glm::mix(looks[m].colour, downy_brow, head.measures.skull_infant)
                                            : looks[m].colour,
             1.0);
    look.roughness = looks[m].roughness;
  }
  mesh.morph_weights.assign(shapes.size(), 0.0);
  Model model = single_mesh_model(std::move(mesh));
  model.materials = std::move(materials);
  return model;
}

std::vector<std::uint32_t> head_vertices(const Head& head) {
  std::vector<std::uint32_t> out;
  for (const MaterialPart& part : parts_of(head)) out.insert(out.end(), part.vertices.begin(), part.vertices.end());
  return out;
}

std::vector<std::uint32_t> model_vertices(const Head& head) {
  std::vector<std::uint32_t> out(head.positions.size(), 0);
  std::vector<bool> seen(head.positions.size(), false);
  std::uint32_t first = 0;
  for (const MaterialPart& part : parts_of(head)) {
    for (std::uint32_t i = 0; i < part.vertices.size(); ++i)
      if (!seen[part.vertices[i]]) {
        seen[part.vertices[i]] = true;
        out[part.vertices[i]] = first + i;
      }
    first += static_cast<std::uint32_t>(part.vertices.size());
  }
  return out;
}

}  // namespace sinew
