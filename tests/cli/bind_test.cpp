/// sinew bind and sinew weights.

#include <csignal>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/program.h"

namespace sinew::test {
namespace {

using Json = nlohmann::json;

class Bind : public ProgramTest {
 protected:
  void SetUp() override {
    ASSERT_EQ(run({"figure", "--joints", "23", "-o", "figure.glb"}).exit_code, 0);
    ASSERT_EQ(run({"export", "figure.glb", "--by", "cpu", "-o", "bare.obj"}).exit_code, 0);
  }
};

TEST_F(Bind, ABareMeshFollowsASkeleton) {
  const Json report = json({"bind", "bare.obj", "figure.glb", "-o", "bound.glb"});
  for (const char* key :
       {"file", "vertices", "joints", "max_influences", "outside", "idle", "far_vertices", "farthest", "height", "ms"})
    EXPECT_TRUE(report.contains(key)) << key;
  EXPECT_LE(report["max_influences"], 4);
  EXPECT_EQ(report["far_vertices"], 0) << report.dump(1);
  EXPECT_TRUE(report["idle"].empty()) << report.dump(1);
  const Json info = json({"info", "bound.glb"});
  EXPECT_EQ(info["joints"], json({"info", "figure.glb"})["joints"]);
  EXPECT_EQ(info["vertices"], report["vertices"]);
  EXPECT_EQ(json({"bind", "bare.obj", "figure.glb", "--influences", "2", "-o", "two.glb"})["max_influences"], 2);
}

TEST_F(Bind, TheSameBytesEveryTime) {
  for (const char* name : {"a.glb", "b.glb"})
    ASSERT_EQ(run({"bind", "bare.obj", "figure.glb", "-o", name}).exit_code, 0);
  EXPECT_EQ(read("a.glb"), read("b.glb"));
}

TEST_F(Bind, WeightsAreTakenFromAnotherMesh) {
  ASSERT_EQ(run({"bind", "bare.obj", "figure.glb", "--from", "figure.glb", "-o", "taken.glb"}).exit_code, 0);
  // It is the same mesh, but for seams and rounding: bent, it is where the figure is.
  for (const char* name : {"figure", "taken"})
    ASSERT_EQ(run({"export", std::string(name) + ".glb", "--pose", "leftLowerArm=0,-90,0", "--by", "cpu", "--bulge",
                   "off", "-o", std::string(name) + ".ply"})
                  .exit_code,
              0);
  EXPECT_EQ(read("figure.ply").size(), read("taken.ply").size());
}

TEST_F(Bind, WeightsAreEdited) {
  const Json before = json({"info", "figure.glb"});
  const Json edited = json({"weights", "figure.glb", "--smooth", "1", "--mirror", "left", "--prune", "0.02",
                            "--influences", "2", "-o", "edited.glb"});
  EXPECT_EQ(edited["max_influences"], 2);
  EXPECT_EQ(edited["vertices"], before["vertices"]);
  EXPECT_EQ(json({"info", "edited.glb"})["max_influences"], 2);
  const Json same = json({"weights", "figure.glb", "-o", "same.glb"});
  EXPECT_EQ(same["influences"], same["influences_before"]);
}

TEST_F(Bind, WrongUsageAndBadInput) {
  const auto code = [&](const Arguments& words) { return run(words).exit_code; };
  EXPECT_EQ(code({"bind", "bare.obj", "-o", "x.glb"}), 2);
  EXPECT_EQ(code({"bind", "bare.obj", "figure.glb", "-o", "x.obj"}), 2);
  EXPECT_EQ(code({"bind", "bare.obj", "figure.glb", "--influences", "0", "-o", "x.glb"}), 2);
  EXPECT_EQ(code({"bind", "bare.obj", "figure.glb", "--resolution", "4", "-o", "x.glb"}), 2);
  EXPECT_EQ(code({"weights", "figure.glb", "--mirror", "up", "-o", "x.glb"}), 2);
  EXPECT_EQ(code({"weights", "figure.glb", "--prune", "1", "-o", "x.glb"}), 2);
  EXPECT_EQ(code({"bind", "none.obj", "figure.glb", "-o", "x.glb"}), 3);
  EXPECT_EQ(code({"bind", "bare.obj", "bare.obj", "-o", "x.glb"}), 3);
  EXPECT_EQ(code({"bind", "bare.obj", "figure.glb", "--leave-out", "tail", "-o", "x.glb"}), 3);
  EXPECT_EQ(code({"weights", "bare.obj", "-o", "x.glb"}), 3);
  EXPECT_EQ(code({"bind", "bare.obj", "figure.glb", "-o", "figure.glb"}), 7);
  write("far.obj", "v 100 0 0\nv 101 0 0\nv 100 1 0\nf 1 2 3\n");
  const ProgramResult far = run({"bind", "far.obj", "figure.glb", "-o", "x.glb"});
  EXPECT_EQ(far.exit_code, 3);
  EXPECT_NE(far.err.find("no joint of the skeleton lies in it"), std::string::npos) << far;
  EXPECT_FALSE(names().contains("x.glb"));
}

TEST_F(Bind, ASignalLeavesNothingBehind) {
  ASSERT_EQ(run({"figure", "--vertices", "60000", "-o", "large.glb"}).exit_code, 0);
  RunningProgram program({"bind", path("large.glb"), path("large.glb"), "--resolution", "384", "-o", path("x.glb")});
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  program.send(SIGINT);
  EXPECT_EQ(program.finish().exit_code, 130);
  for (const std::string& name : names()) EXPECT_EQ(name.find("x.glb"), std::string::npos) << name;
}

}  // namespace
}  // namespace sinew::test
