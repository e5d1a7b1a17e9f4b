/// The compute shader against the reference, as `sinew parity` tells it.

#include "tests/support/assets.h"
#include "tests/support/gltf_corpus.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

class Parity : public ProgramTest {};

TEST_F(Parity, ArmByEveryDeformerWithEveryBulge) {
  const auto scene = json({"info", arm_scene});
  for (const char* deformer : {"rigid", "ssd"})
    for (const char* bulge : {"on", "off", "paper"}) {
      const auto report = json({"parity", arm_scene, "--deformer", deformer, "--bulge", bulge});
      EXPECT_EQ(report["pass"], true) << deformer << ", bulge " << bulge << ": " << report;
      EXPECT_EQ(report["frames"], 48);
      EXPECT_EQ(report["vertices"], scene["vertices"]);
      EXPECT_EQ(report["tolerance"], 1e-5);
    }
}

TEST_F(Parity, PosesAndStrengthAreComparedToo) {
  EXPECT_EQ(
      json({"parity", arm_scene, "--frame", "0", "--pose", "leftLowerArm=20,-100,30", "--strength", "0.3"})["pass"],
      true);
  const double still = json({"parity", arm_scene, "--frame", "0"})["bbox_diagonal"];
  const double bent = json({"parity", arm_scene, "--frame", "0", "--pose", "leftLowerArm=0,-120,0"})["bbox_diagonal"];
  EXPECT_LT(bent, 0.95 * still) << "the pose did not reach the comparison";
}

TEST_F(Parity, ResultDoesNotDependOnThreads) {
  const auto one = json({"parity", arm_scene, "--frames", "0-47:9"}, {.environment = {{"LP_NUM_THREADS", "1"}}});
  const auto two = json({"parity", arm_scene, "--frames", "0-47:9"}, {.environment = {{"LP_NUM_THREADS", "2"}}});
  EXPECT_EQ(one["max_position_error"], two["max_position_error"]);
  EXPECT_EQ(one["rms_position_error"], two["rms_position_error"]);
}

/// Eight frames spread over the first clip, or a bent pose of what a character without clips has.
Arguments movement(const nlohmann::json& info) {
  if (!info["clips"].empty()) {
    const int last = static_cast<int>(std::ceil(info["clips"][0]["duration"].get<double>() * 24.0));
    std::string frames;
    for (int i = 0; i < 8; ++i) frames += (i == 0 ? "" : ",") + std::to_string(i * last / 7);
    return {"--frames", frames};
  }
  Arguments poses;
  for (const auto& [joint, angles] : std::map<std::string, std::string>{{"leftLowerArm", "0,-80,10"},
                                                                        {"rightUpperArm", "10,20,40"},
                                                                        {"rightLowerArm", "0,120,0"},
                                                                        {"rightLowerLeg", "90,0,0"},
                                                                        {"leftUpperLeg", "-60,10,5"},
                                                                        {"leftFoot", "-30,0,0"},
                                                                        {"leftIndexProximal", "0,0,-45"},
                                                                        {"head", "5,50,0"},
                                                                        {"spine", "15,10,5"}})
    if (info["humanoid"].contains(joint)) poses.insert(poses.end(), {"--pose", joint + "=" + angles});
  return poses;
}

/// A run of parity for every character of the assets that has vertices.
std::vector<Arguments> character_runs(const std::filesystem::path& assets, const Arguments& more) {
  std::vector<Arguments> infos, runs;
  const auto files = gltf_files(assets / "characters");
  for (const auto& file : files) infos.push_back({"info", file.string(), "--json"});
  const auto described = run_programs(infos);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto info = json_of(described[i]);
    if (info["vertices"] == 0) continue;
    Arguments all{"parity", files[i].string(), "--json"};
    for (const Arguments& part : {movement(info), more}) all.insert(all.end(), part.begin(), part.end());
    runs.push_back(std::move(all));
  }
  return runs;
}

TEST_F(Parity, EveryCharacterBlended) {
  SINEW_ASSETS_OR_SKIP(assets);
  const auto results = run_all(character_runs(assets, {}));
  EXPECT_GT(results.size(), 20u);
  for (const ProgramResult& result : results) {
    EXPECT_EQ(result.exit_code, 0) << result;
    EXPECT_EQ(json_of(result)["pass"], true) << result.out << result;
  }
}

TEST_F(Parity, EveryCharacterRigidly) {
  SINEW_ASSETS_OR_SKIP(assets);
  for (const ProgramResult& result : run_all(character_runs(assets, {"--deformer", "rigid"}))) {
    EXPECT_EQ(result.exit_code, 0) << result;
    EXPECT_EQ(json_of(result)["pass"], true) << result.out << result;
  }
}

}  // namespace
}  // namespace sinew::test
