/// What the program says without having opened a file: help, version, wrong usage.

#include <regex>

#include "tests/support/program.h"

namespace sinew::test {
namespace {

class Usage : public ProgramTest {};

const std::vector<std::string> commands{"render", "info", "parity", "export", "bench", "compare", "figure"};

TEST_F(Usage, EveryCommandHasHelpWithAnExample) {
  for (const std::string& command : commands) {
    const ProgramResult result = run({command, "--help"});
    EXPECT_EQ(result.exit_code, 0) << result;
    EXPECT_NE(result.out.find("Example: sinew " + command), std::string::npos) << result.out;
    EXPECT_EQ(result.err, "") << result;
    for (const char* option : {"--json", "--quiet", "--verbose", "--progress"})
      EXPECT_NE(result.out.find(option), std::string::npos) << command << " does not tell of " << option;
  }
}

TEST_F(Usage, HelpNamesEveryCommand) {
  const ProgramResult result = run({"--help"});
  EXPECT_EQ(result.exit_code, 0) << result;
  for (const std::string& command : commands) EXPECT_NE(result.out.find("\n  " + command + " "), std::string::npos);
}

TEST_F(Usage, CommandsOfTheDeviceCanBeToldWhichAndToValidate) {
  for (const char* command : {"render", "parity", "export", "bench"}) {
    const ProgramResult result = run({command, "--help"});
    EXPECT_NE(result.out.find("--device"), std::string::npos) << command;
    EXPECT_NE(result.out.find("SINEW_DEVICE"), std::string::npos) << command;
    EXPECT_NE(result.out.find("--validate"), std::string::npos) << command;
  }
}

TEST_F(Usage, VersionIsOneLine) {
  const ProgramResult result = run({"--version"});
  EXPECT_EQ(result.exit_code, 0) << result;
  EXPECT_TRUE(std::regex_match(result.out, std::regex("sinew \\d+\\.\\d+\\.\\d+\n"))) << result.out;
}

/// A wrong use, and what the message must name.
struct Wrong {
  Arguments arguments;
  std::string named;
};

// Each names files that do not exist: were one opened first, the exit code would be 3.
const std::vector<Wrong> wrong_uses{
    {{}, "subcommand"},
    {{"rendre", "absent.json", "-o", "x.png"}, "rendre"},
    {{"render", "absent.json"}, "--output"},
    {{"render", "absent.json", "-o", "x.png", "--sise", "64x64"}, "--sise"},
    {{"render", "absent.json", "-o", "x.png", "--sise=64x64"}, "\"--size\""},
    {{"render", "absent.json", "-o", "x.png", "--shadign", "clay"}, "\"--shading\""},
    {{"render", "absent.json", "-o", "x.png", "--pose", "arm=1,2,3", "--resum"}, "\"--resume\""},
    {{"render", "absent.json", "-o", "x.png", "--quite"}, "\"--quiet\""},
    {{"bench", "absent.json", "--vertex", "9"}, "bench has no option --vertex (did you mean \"--vertices\"?)"},
    {{"compare", "absent.png", "absent.png", "--treshold", "1"}, "\"--threshold\""},
    {{"compare", "absent.png", "absent.png", "--metric", "flop"}, "\"flip\""},
    {{"export", "absent.glb", "-o", "x.obj", "--qqqqqqqqqqqq"}, "export has no option --qqqqqqqqqqqq\n"},
    {{"render", "absent.json", "-o", "x.png", "more.json"}, "more.json"},
    {{"render", "absent.json", "-o", "x.txt"}, ".png"},
    {{"render", "absent.json", "-o", "x"}, ".png"},
    {{"render", "absent.json", "-o", "x.png", "--size", "0x64"}, "--size 0x64"},
    {{"render", "absent.json", "-o", "x.png", "--size", "64"}, "--size 64"},
    {{"render", "absent.json", "-o", "x.png", "--size", "64x99999999999999999999"}, "--size"},
    {{"render", "absent.json", "-o", "x.png", "--samples", "3"}, "--samples 3"},
    {{"render", "absent.json", "-o", "x.png", "--samples", "many"}, "--samples"},
    {{"render", "absent.json", "-o", "x.png", "--view", "fromt"}, "front"},
    {{"render", "absent.json", "-o", "x.png", "--shading", "cley"}, "clay"},
    {{"render", "absent.json", "-o", "x.png", "--background", "#12"}, "--background #12"},
    {{"render", "absent.json", "-o", "x.png", "--deformer", "sdd"}, "ssd"},
    {{"render", "absent.json", "-o", "x.png", "--deformer", "dqs"}, "dqs"},
    {{"render", "absent.json", "-o", "x.png", "--deformer", "cor"}, "cor"},
    {{"render", "absent.json", "-o", "x.png", "--bulge", "yes"}, "--bulge yes"},
    {{"render", "absent.json", "-o", "x.png", "--pose", "arm"}, "JOINT=x,y,z"},
    {{"render", "absent.json", "-o", "x.png", "--pose", "arm=1,2"}, "three angles"},
    {{"render", "absent.json", "-o", "x.png", "--pose", "arm=1,2,up"}, "arm=1,2,up"},
    {{"render", "absent.json", "-o", "x.png", "--pose", "arm=1,2,nan"}, "arm=1,2,nan"},
    {{"render", "absent.json", "-o", "x.png", "--fps", "-1"}, "--fps"},
    {{"render", "absent.json", "-o", "x.png", "--strength", "1.5"}, "--strength"},
    {{"render", "absent.json", "-o", "x.png", "--frame", "1", "--frames", "2"}, "--frame"},
    {{"render", "absent.json", "-o", "x.png", "--frame", "1-2"}, "--frame 1-2"},
    {{"render", "absent.json", "-o", "x.png", "--frames", "0-3"}, "####"},
    {{"render", "absent.json", "-o", "x_####.png", "--frames", "3-0"}, "3-0"},
    {{"render", "absent.json", "-o", "x_####.png", "--frames", "1,,2"}, "expected a frame"},
    {{"render", "absent.json", "-o", "x_####.png", "--frames", "0-9:0"}, "0-9:0"},
    {{"render", "absent.json", "-o", "x_####.png", "--frames", "-3"}, "-3"},
    {{"render", "absent.json", "-o", "x.png", "--progress", "loud"}, "--progress loud"},
    {{"info"}, "info"},
    {{"info", "absent.glb", "--pose", "arm=1"}, "--pose arm=1"},
    {{"parity", "absent.json", "--tolerance", "-1"}, "--tolerance"},
    {{"parity", "absent.json", "--tolerance", "small"}, "--tolerance"},
    {{"parity", "absent.json", "--frames", "a-b"}, "a-b"},
    {{"export", "absent.glb"}, "--output"},
    {{"export", "absent.glb", "-o", "x.fbx"}, "x.fbx"},
    {{"export", "absent.glb", "-o", "x.obj", "--frames", "0-3"}, "####"},
    {{"export", "absent.glb", "-o", "x.ply", "--frames", "0-3"}, "####"},
    {{"export", "absent.glb", "-o", "x.obj", "--rig"}, ".glb"},
    {{"export", "absent.glb", "-o", "x.obj", "--by", "hand"}, "--by hand"},
    {{"bench", "absent.json", "--frames-timed", "0"}, "--frames-timed 0"},
    {{"bench", "absent.json", "--vertices", "-5"}, "--vertices -5"},
    {{"bench", "absent.json", "--size", "axb"}, "--size axb"},
    {{"compare", "absent.png"}, "required"},
    {{"compare", "absent.png", "absent.png", "--tolerance", "256"}, "--tolerance 256"},
    {{"compare", "absent.png", "absent.png", "--pixels", "2"}, "--pixels 2"},
    {{"compare", "absent.png", "absent.png", "--metric", "taste"}, "--metric taste"},
};

TEST_F(Usage, WrongUsageIsFoundBeforeAnyFileIsOpened) {
  std::vector<Arguments> all;
  for (const Wrong& wrong : wrong_uses) all.push_back(wrong.arguments);
  const auto results = run_all(all);
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_EQ(results[i].exit_code, 2) << results[i];
    EXPECT_EQ(results[i].out, "") << results[i];
    EXPECT_NE(results[i].err.find(wrong_uses[i].named), std::string::npos)
        << "the message does not name \"" << wrong_uses[i].named << '"' << results[i];
  }
  EXPECT_TRUE(names().empty());
}

// The other way round: with the usage right, the same files are found missing.
TEST_F(Usage, RightUsageOfAbsentFilesIsBadInput) {
  const std::vector<Arguments> all{
      {"render", "absent.json", "-o", "x.png"}, {"info", "absent.glb"},   {"parity", "absent.json"},
      {"export", "absent.glb", "-o", "x.obj"},  {"bench", "absent.json"}, {"compare", "absent.png", "absent.png"}};
  for (const ProgramResult& result : run_all(all)) {
    EXPECT_EQ(result.exit_code, 3) << result;
    EXPECT_NE(result.err.find("absent."), std::string::npos) << result;
    EXPECT_EQ(result.out, "") << result;
  }
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace sinew::test
