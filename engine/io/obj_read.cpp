#include "engine/io/obj_read.h"

#include <sstream>

#include "engine/core/files.h"
#include "engine/core/text.h"

namespace sinew {

Result<PolygonMesh> read_obj(const std::filesystem::path& file) {
  const auto bytes = read_file(file);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  std::istringstream text(std::string(bytes->begin(), bytes->end()));
  PolygonMesh out;
  std::string line, word;
  for (std::size_t number = 1; std::getline(text, line); ++number) {
    std::istringstream words(line);
    if (!(words >> word)) continue;
    if (word == "v") {
      Vec3 p;
      for (int i = 0; i < 3; ++i) {
        const auto value = words >> word ? parse_number(word) : std::nullopt;
        if (!value) return bad_input("{}: line {}: expected three numbers after v", file.string(), number);
        p[i] = *value;
      }
      out.positions.push_back(p);
    } else if (word == "f") {
      std::vector<std::uint32_t> polygon;
      while (words >> word) {
        const auto index = parse_integer(split(word, '/')[0]);
        const auto count = static_cast<long long>(out.positions.size());
        if (!index || *index == 0 || *index > count || *index < -count)
          return bad_input("{}: line {}: \"{}\" is no vertex; there are {} before it", file.string(), number, word,
                           count);
        polygon.push_back(static_cast<std::uint32_t>(*index > 0 ? *index - 1 : count + *index));
      }
      if (polygon.size() < 3)
        return bad_input("{}: line {}: a face of {} corners", file.string(), number, polygon.size());
      out.polygons.push_back(std::move(polygon));
    }
  }
  return out;
}

}  // namespace sinew
