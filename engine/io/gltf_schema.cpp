#include "engine/io/gltf_schema.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <span>
#include <string_view>

namespace sinew::gltf {
namespace {

using nlohmann::json;

enum class Kind { flag, whole, number, text, reference, object, reference_map };

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

struct Property {
  std::string_view name;
  Kind kind = Kind::flag;
  double low = -FLT_MAX, high = FLT_MAX;         ///< of a number; what a float cannot hold is no length or angle
  std::string_view refers_to = {};               ///< the top-level list that a reference points into
  std::span<const Property> shape = {};          ///< of an object
  std::span<const std::string_view> words = {};  ///< a text must be one of these, if any
  std::span<const int> choices = {};             ///< a whole number must be one of these, if any
  bool required = false;
  bool list = false;
  std::size_t fewest = 0, most = unlimited;  ///< items of a list
};

// The numbers below are glTF's, but for the greatest lengths: those bound the memory that a small file can claim.
constexpr double greatest_whole = std::numeric_limits<int>::max();

constexpr Property flag(std::string_view name) { return {.name = name, .kind = Kind::flag}; }
constexpr Property text(std::string_view name) { return {.name = name, .kind = Kind::text}; }
constexpr Property number(std::string_view name, double low = -FLT_MAX) {
  return {.name = name, .kind = Kind::number, .low = low};
}
constexpr Property whole(std::string_view name, double low = 0, double high = greatest_whole) {
  return {.name = name, .kind = Kind::whole, .low = low, .high = high};
}
constexpr Property word(std::string_view name, std::span<const std::string_view> words) {
  return {.name = name, .kind = Kind::text, .words = words};
}
constexpr Property choice(std::string_view name, std::span<const int> choices) {
  return {.name = name, .kind = Kind::whole, .low = 0, .high = greatest_whole, .choices = choices};
}
constexpr Property reference(std::string_view name, std::string_view to) {
  return {.name = name, .kind = Kind::reference, .refers_to = to};
}
constexpr Property reference_map(std::string_view name, std::string_view to) {
  return {.name = name, .kind = Kind::reference_map, .refers_to = to};
}
constexpr Property object(std::string_view name, std::span<const Property> shape) {
  return {.name = name, .kind = Kind::object, .shape = shape};
}
constexpr Property required(Property p) {
  p.required = true;
  return p;
}
constexpr Property list(Property p, std::size_t fewest = 0, std::size_t most = unlimited) {
  p.list = true;
  p.fewest = fewest;
  p.most = most;
  return p;
}

constexpr int component_types[] = {5120, 5121, 5122, 5123, 5125, 5126};
constexpr int index_types[] = {5121, 5123, 5125};
constexpr int strides[] = {4,   8,   12,  16,  20,  24,  28,  32,  36,  40,  44,  48,  52,  56,  60,  64,
                           68,  72,  76,  80,  84,  88,  92,  96,  100, 104, 108, 112, 116, 120, 124, 128,
                           132, 136, 140, 144, 148, 152, 156, 160, 164, 168, 172, 176, 180, 184, 188, 192,
                           196, 200, 204, 208, 212, 216, 220, 224, 228, 232, 236, 240, 244, 248, 252};
constexpr int wraps[] = {33071, 33648, 10497};
constexpr int filters[] = {9728, 9729, 9984, 9985, 9986, 9987};
constexpr std::string_view types[] = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
constexpr std::string_view alpha_modes[] = {"OPAQUE", "MASK", "BLEND"};
constexpr std::string_view interpolations[] = {"LINEAR", "STEP", "CUBICSPLINE"};

constexpr Property asset[] = {required(text("version")), text("minVersion")};
constexpr Property buffer[] = {text("uri"), required(whole("byteLength", 1))};
constexpr Property buffer_view[] = {required(reference("buffer", "buffers")), whole("byteOffset"),
                                    required(whole("byteLength", 1)), choice("byteStride", strides)};
constexpr Property sparse_indices[] = {required(reference("bufferView", "bufferViews")), whole("byteOffset"),
                                       required(choice("componentType", index_types))};
constexpr Property sparse_values[] = {required(reference("bufferView", "bufferViews")), whole("byteOffset")};
constexpr Property sparse[] = {required(whole("count", 1)), required(object("indices", sparse_indices)),
                               required(object("values", sparse_values))};
constexpr Property accessor[] = {reference("bufferView", "bufferViews"),
                                 whole("byteOffset"),
                                 required(choice("componentType", component_types)),
                                 flag("normalized"),
                                 required(whole("count", 1)),
                                 required(word("type", types)),
                                 object("sparse", sparse)};
constexpr Property primitive[] = {required(reference_map("attributes", "accessors")), reference("indices", "accessors"),
                                  reference("material", "materials"), whole("mode", 0, 6),
                                  list(reference_map("targets", "accessors"))};
constexpr Property mesh[] = {text("name"), required(list(object("primitives", primitive), 1)), list(number("weights"))};
constexpr Property node[] = {text("name"),
                             reference("mesh", "meshes"),
                             reference("skin", "skins"),
                             list(reference("children", "nodes")),
                             list(number("matrix"), 16, 16),
                             list(number("translation"), 3, 3),
                             list(number("rotation"), 4, 4),
                             list(number("scale"), 3, 3),
                             list(number("weights"))};
constexpr Property scene[] = {text("name"), list(reference("nodes", "nodes"))};
constexpr Property skin[] = {text("name"), reference("inverseBindMatrices", "accessors"),
                             reference("skeleton", "nodes"), required(list(reference("joints", "nodes"), 1))};
constexpr Property texture_info[] = {required(reference("index", "textures")), whole("texCoord")};
constexpr Property normal_texture_info[] = {required(reference("index", "textures")), whole("texCoord"),
                                            number("scale")};
constexpr Property occlusion_texture_info[] = {required(reference("index", "textures")), whole("texCoord"),
                                               number("strength")};
constexpr Property metallic_roughness[] = {list(number("baseColorFactor"), 4, 4),
                                           object("baseColorTexture", texture_info), number("metallicFactor"),
                                           number("roughnessFactor"), object("metallicRoughnessTexture", texture_info)};
constexpr Property material[] = {text("name"),
                                 object("pbrMetallicRoughness", metallic_roughness),
                                 object("normalTexture", normal_texture_info),
                                 object("occlusionTexture", occlusion_texture_info),
                                 object("emissiveTexture", texture_info),
                                 list(number("emissiveFactor"), 3, 3),
                                 word("alphaMode", alpha_modes),
                                 number("alphaCutoff", 0.0),
                                 flag("doubleSided")};
constexpr Property texture[] = {text("name"), reference("sampler", "samplers"), reference("source", "images")};
constexpr Property image[] = {text("name"), text("uri"), text("mimeType"), reference("bufferView", "bufferViews")};
constexpr Property sampler[] = {choice("magFilter", filters), choice("minFilter", filters), choice("wrapS", wraps),
                                choice("wrapT", wraps)};
constexpr Property target[] = {reference("node", "nodes"), required(text("path"))};
constexpr Property channel[] = {required(whole("sampler")), required(object("target", target))};
constexpr Property animation_sampler[] = {required(reference("input", "accessors")),
                                          required(reference("output", "accessors")),
                                          word("interpolation", interpolations)};
constexpr Property animation[] = {text("name"), required(list(object("channels", channel))),
                                  required(list(object("samplers", animation_sampler)))};

constexpr std::size_t many = 200'000, fewer = 10'000;
constexpr Property root[] = {required(object("asset", asset)),
                             reference("scene", "scenes"),
                             list(text("extensionsUsed"), 0, fewer),
                             list(text("extensionsRequired"), 0, fewer),
                             list(object("buffers", buffer), 0, fewer),
                             list(object("bufferViews", buffer_view), 0, many),
                             list(object("accessors", accessor), 0, many),
                             list(object("meshes", mesh), 0, many),
                             list(object("nodes", node), 0, many),
                             list(object("scenes", scene), 0, fewer),
                             list(object("skins", skin), 0, fewer),
                             list(object("materials", material), 0, fewer),
                             list(object("textures", texture), 0, fewer),
                             list(object("images", image), 0, fewer),
                             list(object("samplers", sampler), 0, fewer),
                             list(object("animations", animation), 0, fewer)};

/// What stands there, short enough for a message.
std::string found(const json& value) {
  if (value.is_number() || value.is_boolean() || value.is_null()) return value.dump();
  if (value.is_string()) return fmt::format("\"{:.40}\"", value.get_ref<const std::string&>());
  return value.is_array() ? "a list" : "an object";
}

std::string below(const std::string& place, std::string_view name) {
  return place.empty() ? std::string(name) : fmt::format("{}/{}", place, name);
}

class Conformer {
 public:
  explicit Conformer(const json& document) : document_(document) {}

  Result<json> object(const json& value, std::span<const Property> shape, const std::string& place) const {
    if (!value.is_object()) return wrong(place, "an object", value);
    json copy = json::object();
    for (const Property& property : shape) {
      const auto at = value.find(property.name);
      if (at == value.end()) {
        if (property.required) return bad_input("{}: missing; glTF requires it", below(place, property.name));
        continue;
      }
      auto part = property.list ? items(*at, property, below(place, property.name))
                                : single(*at, property, below(place, property.name));
      if (!part) return part;
      copy[std::string(property.name)] = std::move(*part);
    }
    return copy;
  }

 private:
  static tl::unexpected<Error> wrong(const std::string& place, std::string_view expected, const json& value) {
    return bad_input("{}: must be {}, found {}", place.empty() ? "the document" : place, expected, found(value));
  }

  Result<json> items(const json& value, const Property& property, const std::string& place) const {
    if (!value.is_array()) return wrong(place, "a list", value);
    if (value.size() < property.fewest || value.size() > property.most)
      return bad_input("{}: has {} items; {} are expected", place, value.size(), length_words(property));
    json copy = json::array();
    copy.get_ref<json::array_t&>().reserve(value.size());
    for (const json& item : value) {
      // The place is text and costs an allocation: numbers, which may be many, go without until one is wrong.
      auto part = property.kind == Kind::object ? single(item, property, below(place, std::to_string(copy.size())))
                                                : single(item, property, {});
      if (!part && property.kind != Kind::object)
        part = single(item, property, fmt::format("{}/{}", place, copy.size()));
      if (!part) return part;
      copy.push_back(std::move(*part));
    }
    return copy;
  }

  static std::string length_words(const Property& property) {
    if (property.fewest == property.most) return std::to_string(property.fewest);
    if (property.most == unlimited) return fmt::format("at least {}", property.fewest);
    return fmt::format("{} to {}", property.fewest, property.most);
  }

  Result<json> single(const json& value, const Property& property, const std::string& place) const {
    switch (property.kind) {
      case Kind::flag:
        if (!value.is_boolean()) return wrong(place, "true or false", value);
        return value;
      case Kind::number:
        return number(value, property, place);
      case Kind::text:
        return text(value, property, place);
      case Kind::whole:
        return whole(value, property, place);
      case Kind::reference:
        return reference(value, property.refers_to, place);
      case Kind::object:
        return object(value, property.shape, place);
      case Kind::reference_map:
        return reference_map(value, property, place);
    }
    return json();
  }

  static Result<json> number(const json& value, const Property& property, const std::string& place) {
    if (!value.is_number()) return wrong(place, "a number", value);
    const double x = value.get<double>();
    if (!(x >= property.low && x <= property.high))
      return wrong(place, fmt::format("a number from {:.6g} to {:.6g}", property.low, property.high), value);
    return value;
  }

  static Result<json> text(const json& value, const Property& property, const std::string& place) {
    if (!value.is_string()) return wrong(place, "a text", value);
    if (!property.words.empty() && std::ranges::count(property.words, value.get_ref<const std::string&>()) == 0)
      return wrong(place, fmt::format("one of {}", fmt::join(property.words, ", ")), value);
    return value;
  }

  static Result<json> whole(const json& value, const Property& property, const std::string& place) {
    const double x = value.is_number() ? value.get<double>() : -1.0;
    if (!(x >= property.low && x <= property.high && x == std::floor(x)))
      return wrong(place, fmt::format("a whole number from {:.0f} to {:.0f}", property.low, property.high), value);
    if (!property.choices.empty() && std::ranges::count(property.choices, static_cast<int>(x)) == 0)
      return wrong(place, fmt::format("one of {}", fmt::join(property.choices, ", ")), value);
    return json(static_cast<json::number_unsigned_t>(x));
  }

  Result<json> reference(const json& value, std::string_view to, const std::string& place) const {
    const auto list = document_.find(to);
    const std::size_t size = list != document_.end() && list->is_array() ? list->size() : 0;
    const double x = value.is_number() ? value.get<double>() : -1.0;
    if (!(x >= 0 && x < static_cast<double>(size) && x == std::floor(x)))
      return bad_input("{}: refers to {} {}, but there are {}", place, to, found(value), size);
    return json(static_cast<json::number_unsigned_t>(x));
  }

  Result<json> reference_map(const json& value, const Property& property, const std::string& place) const {
    if (!value.is_object()) return wrong(place, "an object", value);
    json copy = json::object();
    for (const auto& [key, item] : value.items()) {
      auto part = reference(item, property.refers_to, below(place, key));
      if (!part) return part;
      copy[key] = std::move(*part);
    }
    return copy;
  }

  const json& document_;
};

}  // namespace

Result<json> conform(const json& document) { return Conformer(document).object(document, root, ""); }

const json* find(const json& value, std::initializer_list<const char*> keys) {
  const json* at = &value;
  for (const char* key : keys) {
    if (!at->is_object()) return nullptr;
    const auto next = at->find(key);
    if (next == at->end()) return nullptr;
    at = &*next;
  }
  return at;
}

}  // namespace sinew::gltf
