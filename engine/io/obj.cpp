#include "engine/io/obj.h"

#include <cassert>
#include <charconv>

#include "engine/core/text.h"

namespace sinew {
namespace {

constexpr int significant_digits = 9;  // enough for every float to come back as it was

/// Text in one growing block: an OBJ has millions of numbers, so nothing is allocated for a single one.
class ObjText {
 public:
  explicit ObjText(std::size_t expected_size) { text_.reserve(expected_size); }

  void add(std::string_view words) { text_.append(words); }

  void add_number(float value) {
    char digits[32];
    // + 0.0f: a negative zero would be written as "-0".
    const auto end =
        std::to_chars(digits, digits + sizeof digits, value + 0.0f, std::chars_format::general, significant_digits);
    text_.push_back(' ');
    text_.append(digits, end.ptr);
  }

  void add_index(std::size_t index) {
    char digits[24];
    text_.append(digits, std::to_chars(digits, digits + sizeof digits, index).ptr);
  }

  void end_line() { text_.push_back('\n'); }

  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

void add_vectors(const char* keyword, const std::vector<Vec3f>& vectors, ObjText& out) {
  for (const Vec3f& v : vectors) {
    out.add(keyword);
    for (int i = 0; i < 3; ++i) out.add_number(v[i]);
    out.end_line();
  }
}

void add_texture_coordinates(const std::vector<Vec2f>& coordinates, ObjText& out) {
  for (const Vec2f& uv : coordinates) {
    out.add("vt");
    out.add_number(uv.x);
    out.add_number(1.0f - uv.y);
    out.end_line();
  }
}

/// Every corner has one index for all that it is made of: a baked vertex has exactly one of each.
void add_triangles(const BakedMesh& mesh, ObjText& out) {
  const std::string_view to_normal = mesh.texture_coordinates.empty() ? "//" : "/";
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::size_t index = std::size_t{mesh.triangles[i]} + 1;
    out.add(i % 3 == 0 ? "f " : " ");
    out.add_index(index);
    if (!mesh.texture_coordinates.empty()) {
      out.add("/");
      out.add_index(index);
    }
    out.add(to_normal);
    out.add_index(index);
    if (i % 3 == 2) out.end_line();
  }
}

}  // namespace

std::string obj_text(const BakedMesh& mesh, std::size_t frame, std::string_view comment) {
  assert(frame < mesh.frames.size());
  const BakedFrame& baked = mesh.frames[frame];
  ObjText out(comment.size() + 90 * baked.positions.size() + 10 * mesh.triangles.size());
  if (!comment.empty()) {
    for (const std::string& line : split(comment, '\n')) {
      out.add("# ");
      out.add(line);
      out.end_line();
    }
  }
  add_vectors("v", baked.positions, out);
  add_texture_coordinates(mesh.texture_coordinates, out);
  add_vectors("vn", baked.normals, out);
  add_triangles(mesh, out);
  return out.take();
}

}  // namespace sinew
