#include "engine/gpu/shader_compiler.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "engine/core/files.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

const fs::path shaders = fs::path(SINEW_SOURCE_DIR) / "shaders";

/// Small shaders in a folder of their own.
class ShaderCompiler : public ::testing::Test {
 protected:
  void SetUp() override {
    // Tests run beside each other.
    const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::path(::testing::TempDir()) / ("shader_compiler_" + test);
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& file, const std::string& text) const { ASSERT_TRUE(write_file(folder_ / file, text)); }
  std::vector<std::uint32_t> code(const std::string& file, const std::vector<std::string>& defines = {}) const {
    auto made = compile_shader({Shader::wire_fragment, file, defines}, folder_);
    EXPECT_TRUE(made) << made.error().message;
    return made ? std::move(*made) : std::vector<std::uint32_t>();
  }
  std::string fault(const std::string& file) const {
    const auto made = compile_shader({Shader::wire_fragment, file, {}}, folder_);
    if (made) return "";
    EXPECT_EQ(made.error().kind, ErrorKind::bad_input);
    return made.error().message;
  }

 private:
  fs::path folder_;
};

// Word for word, so that a program that compiled them anew shows the same pictures.
TEST_F(ShaderCompiler, MakesTheWordsThatTheBuildMakes) {
  TaskWatch watch;
  const auto set = compile_shaders(shaders, watch);
  ASSERT_TRUE(set) << set.error().message;
  EXPECT_EQ(watch.share(), 1.0);
  EXPECT_EQ(set->size(), static_cast<std::size_t>(Shader::wire_fragment) + 1) << "the last of them all";
  for (const auto& [shader, words] : *set) {
    const auto carried = shader_code(shader);
    EXPECT_FALSE(words.empty());
    EXPECT_TRUE(std::ranges::equal(words, carried)) << static_cast<int>(shader);
  }
}

TEST_F(ShaderCompiler, AnErrorNamesFileAndLine) {
  write("wrong.frag",
        "#version 460\nlayout(location = 0) out vec4 colour;\nvoid main() {\n  colour = vec4(nothing);\n}\n");
  const std::string said = fault("wrong.frag");
  EXPECT_TRUE(said.starts_with("wrong.frag:4: ")) << said;
  EXPECT_NE(said.find("'nothing' : undeclared identifier"), std::string::npos) << said;
}

TEST_F(ShaderCompiler, AnErrorInWhatIsIncludedNamesThatFile) {
  const std::string includes =
      "#version 460\n#extension GL_GOOGLE_include_directive : require\n#include \"part.glsl\"\n";
  write("whole.vert", includes + "void main() { gl_Position = place(); }\n");
  EXPECT_TRUE(fault("whole.vert").starts_with("whole.vert:3: ")) << "the part is missing: " << fault("whole.vert");
  write("part.glsl", "vec4 place() {\n  return vec3(1.0);\n}\n");
  EXPECT_TRUE(fault("whole.vert").starts_with("part.glsl:2: ")) << fault("whole.vert");
  write("part.glsl", "vec4 place() {\n  return vec4(1.0);\n}\n");
  EXPECT_FALSE(code("whole.vert").empty());
}

TEST_F(ShaderCompiler, AShaderWithoutMainIsNamed) {
  write("empty.frag", "#version 460\n");
  EXPECT_TRUE(fault("empty.frag").starts_with("empty.frag: ")) << fault("empty.frag");
  EXPECT_NE(fault("absent.frag").find("absent.frag"), std::string::npos);
  write("shader.txt", "#version 460\nvoid main() {}\n");
  EXPECT_NE(fault("shader.txt").find(".frag"), std::string::npos) << "says which endings there are";
}

TEST_F(ShaderCompiler, MacrosAreSet) {
  write("red.frag",
        "#version 460\nlayout(location = 0) out vec4 colour;\nvoid main() {\n#ifdef RED\n  colour = vec4(1, 0, 0, 1);\n"
        "#else\n  colour = vec4(0.25);\n#endif\n}\n");
  EXPECT_NE(code("red.frag"), code("red.frag", {"RED"}));
  EXPECT_EQ(code("red.frag"), code("red.frag", {"GREEN"}));
}

TEST_F(ShaderCompiler, StopsWhenItIsCancelled) {
  TaskWatch watch;
  watch.cancel();
  const auto set = compile_shaders(shaders, watch);
  ASSERT_FALSE(set);
  EXPECT_EQ(set.error().kind, ErrorKind::interrupted);
}

}  // namespace
}  // namespace sinew::test
