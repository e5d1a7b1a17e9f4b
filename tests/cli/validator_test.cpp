/// The files that the program writes, judged by the Khronos glTF validator (tests/validate_gltf.mjs).

#include <array>
#include <cstdio>
#include <cstdlib>

#include "tests/support/assets.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

/// What the validator's script says and how it ends: 0 nothing to say, 1 errors or warnings, 2 it did not run.
struct Verdict {
  int exit_code = -1;
  std::string said;
};

std::string quoted(const std::string& text) { return "'" + text + "'"; }

Verdict validate(const std::vector<std::string>& files) {
  std::string command = "NODE_PATH=" + quoted(SINEW_VALIDATOR) + " node " +
                        quoted(std::string(SINEW_SOURCE_DIR) + "/tests/validate_gltf.mjs");
  for (const std::string& file : files) command += " " + quoted(file);
  Verdict verdict;
  std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return verdict;
  std::array<char, 4096> block{};
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), pipe))
    verdict.said.append(block.data(), count);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) verdict.exit_code = WEXITSTATUS(status);
  return verdict;
}

/// Why the validator cannot be asked, or nothing.
std::string missing_validator() {
  if (std::system("node --version > /dev/null 2>&1") != 0) return "Node.js is missing";
  if (!fs::exists(fs::path(SINEW_VALIDATOR) / "gltf-validator/package.json"))
    return std::string("the npm package gltf-validator is not in ") + SINEW_VALIDATOR +
           ": tools/install_validator.sh fetches it";
  return "";
}

/// Leaves the test where there is no validator: SKIPPED loudly, or failed where nothing may be missing.
#define VALIDATOR_OR_SKIP()                                                        \
  if (const std::string missing = missing_validator(); !missing.empty()) {         \
    if (assets_required()) FAIL() << "SINEW_REQUIRE_ASSETS is 1, but " << missing; \
    GTEST_SKIP() << "SKIPPED: " << missing;                                        \
  }

class Validator : public ProgramTest {
 protected:
  /// Exports with these words into a file of this name; its path.
  std::string exported(const std::string& name, Arguments words) const {
    words.insert(words.begin(), "export");
    words.insert(words.end(), {"-o", name});
    const ProgramResult result = run(words);
    EXPECT_EQ(result.exit_code, 0) << result;
    return path(name);
  }
  /// The same model in the three ways in which it is written.
  std::vector<std::string> exported_in_all_ways(const std::string& stem, const Arguments& model) const {
    const auto with = [&](Arguments more) {
      more.insert(more.begin(), model.begin(), model.end());
      return more;
    };
    return {exported(stem + "_rig.glb", with({"--rig"})), exported(stem + "_frame.glb", with({"--frame", "3"})),
            exported(stem + "_baked.glb", with({"--frames", "0-9:3"}))};
  }
};

TEST_F(Validator, HasNothingToSayAboutTheEmbeddedArm) {
  VALIDATOR_OR_SKIP();
  std::vector<std::string> files = exported_in_all_ways("scene", {});
  for (const std::string& file : exported_in_all_ways("arm", {"builtin:arm"})) files.push_back(file);
  files.push_back(exported("cpu.glb", {"--by", "cpu", "--frames", "0,47"}));
  files.push_back(exported("rigid.glb", {"--deformer", "rigid", "--frame", "47"}));
  const Verdict verdict = validate(files);
  EXPECT_EQ(verdict.exit_code, 0) << verdict.said;
}

TEST_F(Validator, HasNothingToSayAboutRealCharacters) {
  SINEW_ASSETS_OR_SKIP(assets);
  VALIDATOR_OR_SKIP();
  // Of each kind one: MakeHuman, a game character with rigid parts, a walk of 19 joints, morphs alone, morphs and skin,
  // a hand with a picture beside its file, several meshes and animations.
  const std::vector<const char*> characters{"makehuman/mh_male_game.glb",
                                            "kaykit/Knight.glb",
                                            "khronos/CesiumMan.glb",
                                            "khronos/SimpleMorph.gltf",
                                            "khronos/SimpleSkin.gltf",
                                            "godot_hand/LeftHandHumanoid.gltf",
                                            "khronos/Fox.glb",
                                            "mesh2motion/human-male.glb",
                                            "quaternius/modular_men_Suit.glb"};
  for (const char* character : characters) {
    const fs::path file = assets / "characters" / character;
    ASSERT_TRUE(fs::exists(file)) << file;
    std::vector<std::string> files = exported_in_all_ways(file.stem().string(), {file.string()});
    // Its picture, which is handed on as it is, has a colour profile: the validator warns of the input as well.
    if (file.stem() == "LeftHandHumanoid") files.erase(files.begin());
    const Verdict verdict = validate(files);
    EXPECT_EQ(verdict.exit_code, 0) << verdict.said;
  }
}

TEST_F(Validator, HasNothingToSayAboutHeads) {
  VALIDATOR_OR_SKIP();
  std::vector<std::string> files;
  for (const Arguments& words : {Arguments{"--level", "2"}, Arguments{"--level", "0", "--age", "infant"},
                                 Arguments{"--level", "1", "--expression", "laugh"}}) {
    files.push_back(path("head" + std::to_string(files.size()) + ".glb"));
    Arguments arguments{"head", "-o", files.back()};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const ProgramResult result = run(arguments);
    ASSERT_EQ(result.exit_code, 0) << result;
  }
  files.push_back(path("actor.glb"));
  ASSERT_EQ(run({"figure", "--head", "adult", "-o", files.back()}).exit_code, 0);
  const Verdict verdict = validate(files);
  EXPECT_EQ(verdict.exit_code, 0) << verdict.said;
}

TEST_F(Validator, HasNothingToSayAboutMotions) {
  SINEW_ASSETS_OR_SKIP(assets);
  VALIDATOR_OR_SKIP();
  const auto motion = [&](Arguments words) {
    words.insert(words.begin(), "motion");
    words.insert(words.end(), {"--library", path("motions.db")});
    const ProgramResult result = run(words);
    EXPECT_EQ(result.exit_code, 0) << result;
  };
  motion({"import", (assets / "motions/cmu_asfamc/02_01.amc").string(), "--name", "walk"});
  motion({"fit", "walk", "--tolerance", "0.5"});
  motion({"export", "walk", "--model", "builtin:woman", "-o", path("walk.glb")});
  motion({"export", "walk", "-o", path("walk.vrma")});
  // The validator knows a file by its name's end.
  fs::copy_file(path("walk.vrma"), path("walk_vrma.glb"));
  const Verdict verdict = validate({path("walk.glb"), path("walk_vrma.glb")});
  EXPECT_EQ(verdict.exit_code, 0) << verdict.said;
}

TEST_F(Validator, SpeaksWhereSomethingIsWrong) {
  VALIDATOR_OR_SKIP();
  // Were the script deaf, the tests above could not fail.
  Bytes glb = read_file(exported("arm.glb", {"--rig"})).value();
  const std::string text(glb.begin(), glb.end());
  const std::size_t word = text.find("\"NORMAL\"");
  ASSERT_NE(word, std::string::npos);
  glb[word + 1] = 'X';
  ASSERT_TRUE(write_file(path("wrong.glb"), glb));
  const Verdict verdict = validate({path("wrong.glb")});
  EXPECT_EQ(verdict.exit_code, 1) << verdict.said;
  EXPECT_NE(verdict.said.find("XORMAL"), std::string::npos) << verdict.said;
  EXPECT_EQ(validate({path("absent.glb")}).exit_code, 2);
}

}  // namespace
}  // namespace sinew::test
