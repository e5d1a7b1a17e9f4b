/// sinew motion: the library from the command line.

#include <csignal>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/assets.h"
#include "tests/support/program.h"

namespace sinew::test {
namespace {

using Json = nlohmann::json;

class MotionCommand : public ProgramTest {
 protected:
  MotionCommand() {
    std::string text =
        "HIERARCHY\nROOT Hips\n{\n OFFSET 0 1 0\n CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
        "Yrotation\n JOINT Neck\n {\n  OFFSET 0 0.5 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n  End Site\n  {\n"
        "   OFFSET 0 0.2 0\n  }\n }\n}\nMOTION\nFrames: 90\nFrame Time: 0.033333333\n";
    for (int i = 0; i < 90; ++i)
      text += fmt::format("0 1 0 0 0 0 {:.6f} {:.6f} 0\n", 10 * std::sin(i * 0.1), -25 * std::sin(i * 0.05));
    write("nod.bvh", text);
  }

  Arguments with_library(Arguments arguments) const {
    arguments.insert(arguments.begin(), "motion");
    arguments.insert(arguments.end(), {"--library", path("motions.db")});
    return arguments;
  }
  Json motion(const Arguments& arguments) const { return json(with_library(arguments)); }
  int code(const Arguments& arguments) const { return run(with_library(arguments)).exit_code; }
};

TEST_F(MotionCommand, TheDegreesFollowFromTheSkin) {
  SINEW_ASSETS_OR_SKIP(assets);
  motion({"import", (assets / "motions/cmu_asfamc/02_01.amc").string(), "--name", "walk"});
  const Json wide = motion({"fit", "walk", "--tolerance", "1"});
  EXPECT_GT(wide["skin_error_mm"].get<double>(), 5.0);
  const Json fit = motion({"fit", "walk", "--skin-tolerance", "5"});
  EXPECT_LE(fit["skin_error_mm"].get<double>(), 5.0);
  // Not far below: what is not needed is not stored.
  EXPECT_GT(fit["skin_error_mm"].get<double>(), 2.0);
  EXPECT_GT(fit["stored_numbers"].get<int>(), wide["stored_numbers"].get<int>());
  EXPECT_EQ(code({"fit", "walk", "--skin-tolerance", "0"}), 2);
}

TEST_F(MotionCommand, GoesFromAFileToAPlot) {
  const Json imported = motion({"import", "nod.bvh", "--tag", "head", "--emotion", "laugh"});
  EXPECT_EQ(imported["clips"], Json({"nod"}));
  const Json listed = motion({"list"});
  ASSERT_EQ(listed["clips"].size(), 1u);
  const Json& clip = listed["clips"][0];
  EXPECT_EQ(clip["name"], "nod");
  EXPECT_EQ(clip["frames"], 90);
  EXPECT_EQ(clip["joints"], 2);
  EXPECT_EQ(clip["tags"], Json({"head"}));
  EXPECT_EQ(clip["emotion"], "laugh");
  EXPECT_NEAR(clip["duration"].get<double>(), 89 / 30.0, 1e-4);

  const Json fit = motion({"fit", "nod", "--tolerance", "0.5"});
  EXPECT_EQ(fit["clip"], "nod");
  ASSERT_EQ(fit["curves"].size(), 6u);
  for (const Json& curve : fit["curves"]) {
    for (const char* key : {"joint", "axis", "order", "samples", "segments", "degree", "rmse_degrees", "max_degrees"})
      EXPECT_TRUE(curve.contains(key)) << key;
    EXPECT_LE(curve["max_degrees"].get<double>(), 0.5);
  }
  EXPECT_EQ(fit["sampled_numbers"], 90 * 9);
  EXPECT_LT(fit["stored_numbers"].get<int>(), 90);
  EXPECT_GT(fit["skin_error_mm"].get<double>(), 0.0);

  motion({"edit", "nod", "--as", "big", "--scale", "Neck=1.5", "--warp", "1.2", "--offset", "Neck.x=-3"});
  const Json shown = motion({"show", "big"});
  EXPECT_EQ(shown["parent"], "nod");
  EXPECT_EQ(shown["edit"][0]["operation"], "scale");
  EXPECT_EQ(shown["edit"][1]["operation"], "warp");
  EXPECT_EQ(shown["edit"][2]["degrees"], -3.0);
  motion({"edit", "big", "--apex", "1.5", "--tag", "large"});
  EXPECT_EQ(motion({"show", "big"})["apex"], 1.5);
  EXPECT_EQ(motion({"list", "--tag", "large"})["clips"].size(), 1u);

  motion({"export", "big", "-o", "big.bvh"});
  motion({"import", "big.bvh", "--name", "back"});
  EXPECT_EQ(motion({"show", "back"})["frames"], shown["frames"]);

  for (const char* name : {"nod.svg", "nod.png"}) {
    const ProgramResult plot = run(with_library({"plot", "nod", "--joint", "neck", "-o", name}));
    EXPECT_EQ(plot.exit_code, 0) << plot;
    EXPECT_GT(read(name).size(), 2000u);
  }
}

TEST_F(MotionCommand, SaysWhatIsWrongAndLeavesTheLibraryAsItWas) {
  motion({"import", "nod.bvh"});
  write("broken.bvh", "HIERARCHY\nROOT Hips\n{\n OFFSET 0 1\n");
  const Bytes nod = read("nod.bvh");
  write("good.bvh", std::string(nod.begin(), nod.end()));
  EXPECT_EQ(code({"import", "good.bvh", "broken.bvh"}), 3);
  EXPECT_EQ(code({"import", "good.bvh", "nod.bvh"}), 3);
  EXPECT_EQ(code({"fit", "node"}), 3);
  EXPECT_EQ(code({"fit", "nod", "--degree", "2"}), 2);
  EXPECT_EQ(code({"fit", "nod", "--joint", "nek"}), 3);
  EXPECT_EQ(code({"fit", "nod", "--tolerance", "-1"}), 2);
  EXPECT_EQ(code({"fit", "nod", "--segments", "many"}), 2);
  EXPECT_EQ(code({"plot", "nod", "--joint", "Neck", "-o", "x.svg"}), 3);  // not fitted yet
  EXPECT_EQ(code({"plot", "nod", "--joint", "Neck", "-o", "x.bmp"}), 2);
  EXPECT_EQ(code({"edit", "nod", "--as", "new", "--scale", "Nekc=2"}), 3);
  EXPECT_EQ(code({"edit", "nod", "--scale", "Neck=2"}), 2);
  EXPECT_EQ(code({"edit", "nod", "--as", "new", "--crop", "1"}), 2);
  EXPECT_EQ(code({"edit", "nod", "--emotion", "glee"}), 2);
  EXPECT_EQ(code({"edit", "nod", "--apex", "100"}), 3);
  EXPECT_EQ(motion({"list"})["clips"].size(), 1u);
  ProgramOptions without_gnuplot;
  without_gnuplot.environment["PATH"] = path("nowhere");
  motion({"fit", "nod"});
  const ProgramResult plot = run(with_library({"plot", "nod", "--joint", "Neck", "-o", "x.svg"}), without_gnuplot);
  EXPECT_EQ(plot.exit_code, 7) << plot;
  EXPECT_NE(plot.err.find("gnuplot-nox"), std::string::npos);
  EXPECT_EQ(names().count("x.svg"), 0u);
}

TEST_F(MotionCommand, AKilledImportLeavesTheLibraryAsItWas) {
  motion({"import", "nod.bvh"});
  Arguments many{"import"};
  const Bytes bytes = read("nod.bvh");
  for (int i = 0; i < 400; ++i) {
    write(fmt::format("copy{}.bvh", i), std::string(bytes.begin(), bytes.end()));
    many.push_back(fmt::format("copy{}.bvh", i));
  }
  ProgramOptions options;
  options.folder = path("");
  for (const int wait_ms : {50, 150, 300}) {
    RunningProgram running(with_library(many), options);
    std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
    running.send(SIGKILL);
    const ProgramResult killed = running.finish();
    // All or nothing: the signal may come after the transaction and before the end of the program.
    const std::size_t clips = motion({"list"})["clips"].size();
    EXPECT_TRUE(clips == 1u || clips == 401u) << clips << " clips after " << wait_ms << " ms";
    if (killed.signal != SIGKILL) {
      EXPECT_EQ(clips, 401u);
    }
    if (clips == 401u) return;
  }
  motion(many);
  EXPECT_EQ(motion({"list"})["clips"].size(), 401u);
}

}  // namespace
}  // namespace sinew::test
