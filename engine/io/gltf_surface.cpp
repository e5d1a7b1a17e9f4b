#include "engine/io/gltf_surface.h"

#include "engine/io/gltf_access.h"

namespace sinew::gltf {
namespace {

constexpr int coordinate_components[] = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
                                         TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_SHORT,
                                         TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};
constexpr int tangent_components[] = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_BYTE,
                                      TINYGLTF_COMPONENT_TYPE_SHORT};
constexpr int colour_components[] = {TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                     TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT};

class SurfaceReader {
 public:
  SurfaceReader(Document& document, const tinygltf::Primitive& from, const std::string& place,
                const Materials& materials, Primitive& to)
      : document_(document), from_(from), place_(place), to_(to) {
    if (from.material < 0) return;
    material_ = &materials.materials[static_cast<std::size_t>(from.material)];
    sets_ = materials.sets[static_cast<std::size_t>(from.material)];
  }

  Result<void> run() {
    if (auto ok = read_coordinates(0, to_.texture_coordinates); !ok) return ok;
    if (auto ok = read_coordinates(1, to_.second_texture_coordinates); !ok) return ok;
    if (auto ok = read_tangents(); !ok) return ok;
    return read_colours();
  }

 private:
  int accessor(const std::string& attribute) const {
    const auto at = from_.attributes.find(attribute);
    return at == from_.attributes.end() ? -1 : at->second;
  }

  std::string attribute_place(const std::string& attribute) const {
    return fmt::format("{}/attributes/{}", place_, attribute);
  }

  void note_mended(std::size_t count, const std::string& attribute, const char* mend) {
    if (count > 0) document_.problem("{}: {} of {} {}", place_, count, attribute, mend);
  }

  bool textured(int coordinates) const {
    if (material_ == nullptr) return false;
    for (const Texture* texture :
         {&material_->base_colour_texture, &material_->metallic_roughness_texture, &material_->normal_texture,
          &material_->occlusion_texture, &material_->emissive_texture})
      if (texture->there() && texture->coordinates == coordinates) return true;
    return false;
  }

  Result<void> read_coordinates(int which, std::vector<Vec2>& to) {
    const int set = sets_[static_cast<std::size_t>(which)];
    if (set < 0) return {};
    const std::string name = fmt::format("TEXCOORD_{}", set);
    if (accessor(name) < 0) {
      if (textured(which))
        document_.problem("{}: its material's texture needs {}, which is not there; drawn without it", place_, name);
      return {};
    }
    auto numbers = read_accessor(document_, accessor(name), attribute_place(name),
                                 {TINYGLTF_TYPE_VEC2, coordinate_components, "VEC2 of floats, bytes or shorts"});
    if (!numbers) return pass_on(std::move(numbers));
    std::size_t bad = 0;
    to.reserve(numbers->count());
    for (std::size_t v = 0; v < numbers->count(); ++v) {
      const bool finite = numbers->finite(v);
      bad += finite ? 0 : 1;
      to.push_back(finite ? Vec2(numbers->at(v)[0], numbers->at(v)[1]) : Vec2(0.0));
    }
    note_mended(bad, name, "are not finite; taken as 0");
    return {};
  }

  Result<void> read_tangents() {
    // Without a file's own normals its tangents are to be ignored, says glTF.
    if (material_ == nullptr || !material_->normal_texture.there() || accessor("TANGENT") < 0 || accessor("NORMAL") < 0)
      return {};
    auto numbers = read_accessor(document_, accessor("TANGENT"), attribute_place("TANGENT"),
                                 {TINYGLTF_TYPE_VEC4, tangent_components, "VEC4 of floats, or of normalized integers"});
    if (!numbers) return pass_on(std::move(numbers));
    std::size_t long_or_short = 0, sideless = 0;
    to_.tangents.reserve(numbers->count());
    for (std::size_t v = 0; v < numbers->count(); ++v) {
      const double length = numbers->finite(v) ? glm::length(numbers->vec3(v)) : 0.0;
      if (length < 1e-12) {
        document_.problem("{}: tangent {} has no direction; tangents are computed instead", place_, v);
        to_.tangents.clear();
        return {};
      }
      const double side = numbers->at(v)[3];
      long_or_short += std::abs(length - 1.0) > numbers->unit_tolerance() ? 1 : 0;
      sideless += std::abs(side) != 1.0 ? 1 : 0;
      to_.tangents.emplace_back(numbers->vec3(v) / length, side < 0.0 ? -1.0 : 1.0);
    }
    note_mended(long_or_short, "TANGENT", "are not of length 1; normalised");
    note_mended(sideless, "TANGENT", "have a w that is neither 1 nor -1; the nearer is taken");
    return {};
  }

  Result<void> read_colours() {
    const int index = accessor("COLOR_0");
    if (index < 0) return {};
    const int type = document_.gltf.accessors[static_cast<std::size_t>(index)].type;
    const bool has_alpha = type == TINYGLTF_TYPE_VEC4;
    auto numbers = read_accessor(document_, index, attribute_place("COLOR_0"),
                                 {has_alpha ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3, colour_components,
                                  "VEC3 or VEC4 of floats, or of normalized bytes or shorts"});
    if (!numbers) return pass_on(std::move(numbers));
    if (numbers->integer && !document_.gltf.accessors[static_cast<std::size_t>(index)].normalized)
      document_.problem("{}: whole numbers that are not normalized; all but 0 are taken as 1",
                        attribute_place("COLOR_0"));
    std::size_t bad = 0, outside = 0;
    to_.colours.reserve(numbers->count());
    for (std::size_t v = 0; v < numbers->count(); ++v) {
      Vec4 colour(1.0);
      const bool finite = numbers->finite(v);
      bad += finite ? 0 : 1;
      if (finite) colour = Vec4(numbers->vec3(v), has_alpha ? numbers->at(v)[3] : 1.0);
      to_.colours.push_back(glm::clamp(colour, 0.0, 1.0));
      outside += to_.colours.back() != colour && !numbers->integer ? 1 : 0;
    }
    note_mended(bad, "COLOR_0", "are not finite; taken as white");
    note_mended(outside, "COLOR_0", "lie outside 0 to 1; clamped");
    return {};
  }

  Document& document_;
  const tinygltf::Primitive& from_;
  const std::string& place_;
  Primitive& to_;
  const Material* material_ = nullptr;
  CoordinateSets sets_{0, -1};
};

}  // namespace

Result<void> read_surface(Document& document, const tinygltf::Primitive& from, const std::string& place,
                          const Materials& materials, Primitive& to) {
  return SurfaceReader(document, from, place, materials, to).run();
}

}  // namespace sinew::gltf
