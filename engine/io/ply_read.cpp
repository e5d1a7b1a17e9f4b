#include "engine/io/ply_read.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include "engine/core/text.h"

namespace sinew {
namespace {

/// The kinds of numbers, each with its two names.
struct Kind {
  std::string_view name, sized_name;
  std::size_t size;
  bool floating, negative;
};
constexpr std::array<Kind, 8> kinds{{{"char", "int8", 1, false, true},
                                     {"uchar", "uint8", 1, false, false},
                                     {"short", "int16", 2, false, true},
                                     {"ushort", "uint16", 2, false, false},
                                     {"int", "int32", 4, false, true},
                                     {"uint", "uint32", 4, false, false},
                                     {"float", "float32", 4, true, true},
                                     {"double", "float64", 8, true, true}}};

const Kind* find_kind(std::string_view name) {
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) { return k.name == name || k.sized_name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

struct Property {
  std::string name;
  const Kind* kind = nullptr;
  const Kind* count = nullptr;  ///< of a list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

enum class Format { text, little, big };

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  for (std::string& word : split(line, ' '))
    if (!word.empty()) words.push_back(std::move(word));
  return words;
}

class Reader {
 public:
  Reader(const std::filesystem::path& file, const Bytes& bytes)
      : name_(file.string()), text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {}

  Result<PolygonMesh> read() {
    if (auto ok = read_header(); !ok) return pass_on(std::move(ok));
    for (const Element& element : elements_)
      for (std::size_t i = 0; i < element.count; ++i)
        if (auto ok = read_item(element, i); !ok) return pass_on(std::move(ok));
    for (std::size_t i = 0; i < mesh_.polygons.size(); ++i)
      for (const std::uint32_t corner : mesh_.polygons[i])
        if (corner >= mesh_.positions.size())
          return bad_input("{}: face {}: names vertex {} of {}", name_, i, corner, mesh_.positions.size());
    return std::move(mesh_);
  }

 private:
  std::optional<std::string_view> line() {
    const std::size_t end = text_.find('\n', at_);
    if (end == std::string_view::npos) return std::nullopt;
    std::string_view found = text_.substr(at_, end - at_);
    if (found.ends_with('\r')) found.remove_suffix(1);
    at_ = end + 1;
    return found;
  }

  Result<void> read_header() {
    std::size_t number = 0;
    bool has_format = false;
    while (true) {
      const auto found = line();
      ++number;
      if (!found || (number == 1 && *found != "ply"))
        return bad_input("{}: line {}: expected {}", name_, number,
                         number == 1 ? "\"ply\": it is another kind of file" : "end_header: the file is cut off");
      const std::vector<std::string> words = words_of(*found);
      if (number == 1 || words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") break;
      if (words[0] == "format" && words.size() == 3 && read_format(words[1]))
        has_format = true;
      else if (!(words[0] == "element" && read_element(words)) && !(words[0] == "property" && read_property(words)))
        return bad_input("{}: line {}: \"{}\"; expected format, element, property or end_header", name_, number,
                         std::string(found->substr(0, 60)));
    }
    if (!has_format) return bad_input("{}: its header has no format", name_);
    return check_vertices();
  }

  bool read_format(const std::string& word) {
    format_ = word == "binary_little_endian" ? Format::little
              : word == "binary_big_endian"  ? Format::big
                                             : Format::text;
    return format_ != Format::text || word == "ascii";
  }

  bool read_element(const std::vector<std::string>& words) {
    const auto count = words.size() == 3 ? parse_integer(words[2]) : std::nullopt;
    if (!count || *count < 0 || *count > static_cast<long long>(text_.size())) return false;
    elements_.push_back({words[1], static_cast<std::size_t>(*count), {}});
    return true;
  }

  bool read_property(const std::vector<std::string>& words) {
    if (elements_.empty()) return false;
    Property property;
    if (words.size() == 5 && words[1] == "list")
      property = {words[4], find_kind(words[3]), find_kind(words[2])};
    else if (words.size() == 3)
      property = {words[2], find_kind(words[1]), nullptr};
    if (property.kind == nullptr || (words.size() == 5 && (property.count == nullptr || property.count->floating)))
      return false;
    elements_.back().properties.push_back(std::move(property));
    return true;
  }

  Result<void> check_vertices() const {
    for (const Element& element : elements_) {
      if (element.name != "vertex") continue;
      for (const char* axis : {"x", "y", "z"})
        if (std::none_of(element.properties.begin(), element.properties.end(),
                         [&](const Property& p) { return p.name == axis && p.count == nullptr; }))
          return bad_input("{}: its vertices have no {}", name_, axis);
      return {};
    }
    return bad_input("{}: its header has no element vertex", name_);
  }

  std::optional<double> number(const Kind& kind) {
    if (format_ == Format::text) return written_number();
    if (text_.size() - at_ < kind.size) return std::nullopt;
    std::array<unsigned char, 8> bytes{};
    std::memcpy(bytes.data(), text_.data() + at_, kind.size);
    at_ += kind.size;
    static_assert(std::endian::native == std::endian::little, "numbers are copied as they are");
    if (format_ == Format::big) std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(kind.size));
    if (kind.floating) return kind.size == 4 ? as<float>(bytes) : as<double>(bytes);
    if (kind.size == 1) return kind.negative ? as<std::int8_t>(bytes) : as<std::uint8_t>(bytes);
    if (kind.size == 2) return kind.negative ? as<std::int16_t>(bytes) : as<std::uint16_t>(bytes);
    return kind.negative ? as<std::int32_t>(bytes) : as<std::uint32_t>(bytes);
  }

  template <class T>
  static double as(const std::array<unsigned char, 8>& bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof(T));
    return static_cast<double>(value);
  }

  std::optional<double> written_number() {
    constexpr std::string_view blanks = " \t\r\n";
    at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
    const std::size_t end = std::min(text_.find_first_of(blanks, at_), text_.size());
    const std::string_view word = text_.substr(at_, end - at_);
    at_ = end;
    return parse_number(word);
  }

  Result<void> read_item(const Element& element, std::size_t index) {
    const bool vertex = element.name == "vertex", face = element.name == "face";
    const auto wrong = [&](const Property& property, std::string_view what) {
      return bad_input("{}: {} {}: {} {}", name_, element.name, index, property.name, what);
    };
    if (vertex) mesh_.positions.emplace_back(0.0);
    for (const Property& property : element.properties) {
      std::size_t count = 1;
      if (property.count != nullptr) {
        const auto listed = number(*property.count);
        if (!listed || *listed < 0) return wrong(property, "is cut off or has no count");
        count = static_cast<std::size_t>(*listed);
      }
      const bool corners =
          face && property.count != nullptr && (property.name == "vertex_indices" || property.name == "vertex_index");
      if (corners && count < 3) return wrong(property, fmt::format("has {} corners; expected 3 or more", count));
      if (corners) mesh_.polygons.emplace_back();
      for (std::size_t i = 0; i < count; ++i) {
        const auto value = number(*property.kind);
        if (!value) return wrong(property, "is no finite number, or the file is cut off");
        if (corners && !(*value >= 0.0 && *value < static_cast<double>(~0u)))
          return wrong(property, fmt::format("names vertex {}", *value));
        if (corners) mesh_.polygons.back().push_back(static_cast<std::uint32_t>(*value));
        if (vertex && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z') {
          if (!std::isfinite(*value)) return wrong(property, "is no finite number");
          mesh_.positions.back()[property.name[0] - 'x'] = *value;
        }
      }
    }
    return {};
  }

  const std::string name_;
  const std::string_view text_;
  std::size_t at_ = 0;
  Format format_ = Format::text;
  std::vector<Element> elements_;
  PolygonMesh mesh_;
};

}  // namespace

Result<PolygonMesh> read_ply(const std::filesystem::path& file) {
  const auto bytes = read_file(file);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  return Reader(file, *bytes).read();
}

}  // namespace sinew
