#include "engine/view/shader_reload.h"

#include <thread>

#include <gtest/gtest.h>

#include "engine/core/files.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

ShaderSet carried() {
  ShaderSet set;
  for (const ShaderSource& source : shader_sources()) {
    const auto code = shader_code(source.shader);
    set[source.shader].assign(code.begin(), code.end());
  }
  return set;
}

/// A folder, and a compiler that makes of its one file's first letter what the test wants.
class ShaderReloadTest : public ::testing::Test {
 protected:
  void SetUp() override {
    // Tests run beside each other.
    const std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::path(::testing::TempDir()) / ("shader_reload_" + test);
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write("a");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& text) const { ASSERT_TRUE(write_file(folder_ / "x.frag", text)); }
  ShaderBuild build() const {
    return {folder_, [](const fs::path& folder, TaskWatch&) -> Result<ShaderSet> {
              const auto bytes = read_file(folder / "x.frag");
              if (!bytes) return tl::unexpected<Error>(bytes.error());
              if (bytes->front() == '!') return bad_input("x.frag:1: no such thing");
              ShaderSet set = carried();
              if (bytes->front() != 'a') set[Shader::wire_fragment] = {bytes->front()};
              return set;
            }};
  }
  /// What comes of the work that has begun.
  static std::optional<Result<std::shared_ptr<const ShaderSet>>> outcome(ShaderReload& reload) {
    std::optional<Result<std::shared_ptr<const ShaderSet>>> made;
    while (reload.is_busy() && !made) made = reload.take();
    return made;
  }
  /// FileWatch asks the disk four times a second: after this it has asked.
  static bool follows(ShaderReload& reload) {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    return reload.follow();
  }

 private:
  fs::path folder_;
};

TEST_F(ShaderReloadTest, WithoutACompilerNothingIsFollowed) {
  ShaderReload none({});
  EXPECT_FALSE(none.follow());
  ShaderBuild elsewhere = build();
  elsewhere.folder /= "absent";
  ShaderReload carried_away(elsewhere);
  EXPECT_FALSE(carried_away.follow());
}

TEST_F(ShaderReloadTest, OnlyCodeThatIsNewIsHandedOver) {
  ShaderReload reload(build());
  ASSERT_TRUE(reload.follow()) << "the sources may be newer than the program";
  EXPECT_FALSE(outcome(reload)) << "and are not";
  EXPECT_FALSE(follows(reload));
  write("bb");
  ASSERT_TRUE(follows(reload));
  const auto made = outcome(reload);
  ASSERT_TRUE(made && *made);
  EXPECT_EQ((**made)->at(Shader::wire_fragment), std::vector<std::uint32_t>{'b'});
  write("b and a remark");
  ASSERT_TRUE(follows(reload));
  EXPECT_FALSE(outcome(reload));
}

TEST_F(ShaderReloadTest, AFailureIsToldAndSoIsItsEnd) {
  write("!");
  ShaderReload reload(build());
  ASSERT_TRUE(reload.follow());
  const auto failed = outcome(reload);
  ASSERT_TRUE(failed && !*failed);
  EXPECT_EQ(failed->error().message, "x.frag:1: no such thing");
  EXPECT_FALSE(follows(reload)) << "once";
  write("as before");
  ASSERT_TRUE(follows(reload));
  const auto mended = outcome(reload);
  ASSERT_TRUE(mended && *mended);
  EXPECT_EQ(***mended, carried());
}

}  // namespace
}  // namespace sinew::test
