/// Deformed meshes as other programs will read them.

#include <algorithm>
#include <cstring>
#include <sstream>

#include "engine/io/gltf_read.h"
#include "tests/support/assets.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

/// What a mesh file holds, read without the code that wrote it.
struct MeshFile {
  std::vector<Vec3> positions, normals;
  std::vector<std::array<std::size_t, 3>> triangles;  ///< positions' indices from 0
};

MeshFile read_obj(const Bytes& bytes) {
  MeshFile mesh;
  std::istringstream lines(std::string(bytes.begin(), bytes.end()));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    Vec3 v{0.0};
    if (kind == "v" && words >> v.x >> v.y >> v.z) mesh.positions.push_back(v);
    if (kind == "vn" && words >> v.x >> v.y >> v.z) mesh.normals.push_back(v);
    if (kind != "f") continue;
    std::array<std::size_t, 3> triangle{};
    std::string corner, extra;
    for (std::size_t& index : triangle) {
      words >> corner;
      index = std::stoul(corner.substr(0, corner.find('/'))) - 1;
    }
    EXPECT_FALSE(words >> extra) << line;
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

MeshFile read_ply(const Bytes& bytes) {
  const std::string text(bytes.begin(), bytes.end());
  const std::string end = "end_header\n";
  const std::size_t body = text.find(end) + end.size();
  const auto count = [&](const std::string& element) {
    return std::stoul(text.substr(text.find("element " + element + " ") + element.size() + 9));
  };
  EXPECT_TRUE(text.starts_with("ply\nformat binary_little_endian 1.0\n")) << text.substr(0, body);
  const std::size_t vertices = count("vertex"), faces = count("face");
  EXPECT_EQ(bytes.size(), body + vertices * 24 + faces * 13) << text.substr(0, body);
  if (bytes.size() != body + vertices * 24 + faces * 13) return {};
  MeshFile mesh;
  const unsigned char* at = bytes.data() + body;
  for (std::size_t v = 0; v < vertices; ++v, at += 24) {
    std::array<float, 6> numbers{};
    std::memcpy(numbers.data(), at, 24);
    mesh.positions.emplace_back(numbers[0], numbers[1], numbers[2]);
    mesh.normals.emplace_back(numbers[3], numbers[4], numbers[5]);
  }
  for (std::size_t f = 0; f < faces; ++f, at += 13) {
    EXPECT_EQ(*at, 3) << "a face that is no triangle";
    std::array<std::int32_t, 3> corners{};
    std::memcpy(corners.data(), at + 1, 12);
    mesh.triangles.push_back({std::size_t(corners[0]), std::size_t(corners[1]), std::size_t(corners[2])});
  }
  return mesh;
}

/// Of the largest distance between vertices of the same number, over the diagonal of b's box.
double relative_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  EXPECT_EQ(a.size(), b.size());
  if (a.size() != b.size() || b.empty()) return INFINITY;
  Vec3 low = b.front(), high = b.front();
  double largest = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    low = glm::min(low, b[i]);
    high = glm::max(high, b[i]);
    largest = std::max(largest, glm::length(a[i] - b[i]));
  }
  return largest / glm::length(high - low);
}

class Export : public ProgramTest {
 protected:
  void write_mesh(const Arguments& more) const {
    Arguments all{"export"};
    all.insert(all.end(), more.begin(), more.end());
    const ProgramResult result = run(all);
    EXPECT_EQ(result.exit_code, 0) << result;
  }
  Model model(const std::string& name) const {
    auto model = read_gltf(path(name));
    EXPECT_TRUE(model) << model.error().message;
    return model ? std::move(*model) : Model();
  }
};

void expect_sound(const MeshFile& mesh, const nlohmann::json& counts) {
  EXPECT_EQ(mesh.positions.size(), counts["vertices"]);
  EXPECT_EQ(mesh.normals.size(), counts["vertices"]);
  EXPECT_EQ(mesh.triangles.size(), counts["triangles"]);
  for (const Vec3& normal : mesh.normals) EXPECT_NEAR(glm::length(normal), 1.0, 1e-4);
  for (const auto& triangle : mesh.triangles)
    for (const std::size_t index : triangle) EXPECT_LT(index, mesh.positions.size());
}

TEST_F(Export, EveryFormatHoldsTheSameMesh) {
  const auto counts = json({"info", arm_scene});
  for (const char* name : {"x.obj", "x.ply", "x.glb"}) write_mesh({arm_scene, "--frame", "40", "-o", name});
  const MeshFile obj = read_obj(read("x.obj")), ply = read_ply(read("x.ply"));
  expect_sound(obj, counts);
  expect_sound(ply, counts);
  EXPECT_EQ(obj.triangles, ply.triangles);
  // Nine digits give the float back, but for the last bit that reading as a double leaves.
  EXPECT_LT(relative_distance(obj.positions, ply.positions), 1e-8);
  const Model baked = model("x.glb");
  ASSERT_EQ(baked.meshes.size(), 1u);
  ASSERT_EQ(baked.meshes[0].primitives.size(), 1u);
  EXPECT_EQ(baked.meshes[0].primitives[0].indices.size(), 3 * ply.triangles.size());
  EXPECT_LT(relative_distance(baked.meshes[0].primitives[0].positions, ply.positions), 1e-8);
}

TEST_F(Export, ComputePassAndReferenceAgree) {
  for (const char* frame : {"0", "25", "47"}) {
    write_mesh({"--frame", frame, "-o", "gpu.ply"});
    write_mesh({"--frame", frame, "--by", "cpu", "-o", "cpu.ply"});
    const MeshFile gpu = read_ply(read("gpu.ply")), cpu = read_ply(read("cpu.ply"));
    EXPECT_LT(relative_distance(gpu.positions, cpu.positions), 1e-5) << "frame " << frame;
    for (std::size_t v = 0; v < std::min(gpu.normals.size(), cpu.normals.size()); ++v)
      EXPECT_LT(glm::degrees(std::acos(std::min(1.0, glm::dot(gpu.normals[v], cpu.normals[v])))), 0.1)
          << "vertex " << v;
    EXPECT_EQ(gpu.triangles, cpu.triangles);
  }
  // Were both always the same file, the above would prove nothing.
  EXPECT_NE(read("gpu.ply"), read("cpu.ply"));
}

TEST_F(Export, PoseBulgeAndFrameMove) {
  const auto exported = [&](const Arguments& more) {
    Arguments all{"-o", "x.ply"};
    all.insert(all.end(), more.begin(), more.end());
    write_mesh(all);
    return read_ply(read("x.ply")).positions;
  };
  const auto first = exported({});
  EXPECT_LT(relative_distance(exported({"--frame", "0"}), first), 1e-12) << "without a frame it is the first";
  EXPECT_GT(relative_distance(exported({"--frame", "47"}), first), 0.01);
  EXPECT_GT(relative_distance(exported({"--pose", "leftLowerArm=0,-90,0"}), first), 0.01);
  const auto flexed = exported({"--frame", "47"});
  EXPECT_GT(relative_distance(exported({"--frame", "47", "--bulge", "off"}), flexed), 1e-3);
  EXPECT_GT(relative_distance(exported({"--frame", "47", "--strength", "0.5"}), flexed), 1e-3);
  EXPECT_GT(relative_distance(exported({"--frame", "47", "--deformer", "rigid"}), flexed), 1e-3);
}

TEST_F(Export, SequenceIsAFileAFrame) {
  write_mesh({"--frames", "45-47", "-o", "x_####.obj"});
  EXPECT_EQ(names(), (std::set<std::string>{"x_0045.obj", "x_0046.obj", "x_0047.obj"}));
  write_mesh({"--frame", "46", "-o", "alone.obj"});
  EXPECT_EQ(read_obj(read("x_0046.obj")).positions, read_obj(read("alone.obj")).positions);
}

TEST_F(Export, BakedFileHoldsEveryFrame) {
  write_mesh({"--frames", "0-40:10", "-o", "x.glb"});
  const Model baked = model("x.glb");
  ASSERT_EQ(baked.meshes.size(), 1u);
  const Primitive& primitive = baked.meshes[0].primitives.at(0);
  EXPECT_EQ(primitive.morph_targets.size(), 5u) << "a target a frame";
  ASSERT_EQ(baked.clips.size(), 1u);
  EXPECT_NEAR(baked.clips[0].duration, 40.0 / 24.0, 1e-6);
  write_mesh({"--frame", "40", "-o", "last.ply"});
  EXPECT_NE(read_ply(read("last.ply")).positions, primitive.positions);
  // The film of the baked file is that of the scene: its last frame has the last target's shape.
  write_mesh({"x.glb", "--frame", "40", "-o", "replayed.ply"});
  EXPECT_LT(relative_distance(read_ply(read("replayed.ply")).positions, read_ply(read("last.ply")).positions), 1e-6);
}

TEST_F(Export, RigIsTheModelAgain) {
  write_mesh({arm_scene, "--rig", "-o", "rig.glb"});
  const Model rig = model("rig.glb");
  EXPECT_TRUE(rig.problems.empty()) << rig.problems.front();
  const auto scene = json({"info", arm_scene});
  const auto copy = json({"info", "rig.glb"});
  for (const char* key : {"vertices", "triangles", "joints", "max_influences", "humanoid", "morph_targets"})
    EXPECT_EQ(copy[key], scene[key]) << key;
  // The same motion moves it to the same place, and a rig of the rig is the same file.
  write_mesh({"builtin:arm", "--pose", "leftLowerArm=0,-90,0", "-o", "a.ply"});
  write_mesh({"rig.glb", "--pose", "leftLowerArm=0,-90,0", "-o", "b.ply"});
  EXPECT_LT(relative_distance(read_ply(read("a.ply")).positions, read_ply(read("b.ply")).positions), 1e-6);
  write_mesh({"rig.glb", "--rig", "-o", "again.glb"});
  EXPECT_EQ(json({"info", "again.glb"}), copy);
}

TEST_F(Export, RealCharactersInEveryFormat) {
  SINEW_ASSETS_OR_SKIP(assets);
  for (const char* name : {"khronos/Fox.glb", "khronos/CesiumMan.glb", "khronos/AnimatedMorphCube.glb",
                           "mesh2motion/human-male.glb", "quaternius/alien/Alien_Scolitex.gltf"}) {
    const std::string file = (assets / "characters" / name).string();
    const auto counts = json({"info", file});
    for (const char* output : {"x.obj", "x.ply"}) write_mesh({file, "--frame", "9", "-o", output});
    write_mesh({file, "--frame", "9", "--by", "cpu", "-o", "cpu.ply"});
    const MeshFile obj = read_obj(read("x.obj")), ply = read_ply(read("x.ply")), cpu = read_ply(read("cpu.ply"));
    expect_sound(obj, counts);
    expect_sound(ply, counts);
    EXPECT_LT(relative_distance(obj.positions, ply.positions), 1e-8) << name;
    EXPECT_LT(relative_distance(ply.positions, cpu.positions), 1e-5) << name;
    write_mesh({file, "--frames", "0,9", "-o", "x.glb"});
    write_mesh({file, "--rig", "-o", "rig.glb"});
    const auto rig = json({"info", "rig.glb"});
    for (const char* key : {"vertices", "triangles", "joints", "max_influences", "morph_targets"})
      EXPECT_EQ(rig[key], counts[key]) << name << ": " << key;
    EXPECT_EQ(model("x.glb").meshes.size(), 1u);
  }
}

}  // namespace
}  // namespace sinew::test
