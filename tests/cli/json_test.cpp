/// What scripts read: `--json` prints exactly one object with the promised keys.

#include <thread>

#include "tests/support/program.h"

namespace sinew::test {
namespace {

using Json = nlohmann::json;

class JsonOutput : public ProgramTest {};

/// The promised keys of an object; more may be there.
void expect_keys(const Json& json, const std::vector<const char*>& keys, const char* what) {
  ASSERT_TRUE(json.is_object()) << what << ": " << json.dump();
  for (const char* key : keys) EXPECT_TRUE(json.contains(key)) << what << " lacks " << key << ": " << json.dump();
}

void expect_device(const Json& device) {
  expect_keys(device, {"name", "type", "api", "driver"}, "device");
  for (const auto& [key, value] : device.items())
    if (key != "index") {
      EXPECT_TRUE(value.is_string() && !value.get<std::string>().empty()) << key << ": " << value;
    }
}

bool is_hash(const Json& text) {
  return text.is_string() && text.get<std::string>().size() == 64 &&
         text.get<std::string>().find_first_not_of("0123456789abcdef") == std::string::npos;
}

TEST_F(JsonOutput, Render) {
  const Json json =
      this->json({"render", arm_scene, "--frames", "3,0-1", "--size", "96x64", "--fps", "30", "-o", "x_###.png"});
  expect_keys(json, {"device", "frames", "size", "fps"}, "render");
  expect_device(json["device"]);
  EXPECT_EQ(json["size"], Json({96, 64}));
  EXPECT_EQ(json["fps"], 30.0);
  ASSERT_EQ(json["frames"].size(), 3u);
  const int expected[] = {3, 0, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    const Json& frame = json["frames"][i];
    expect_keys(frame, {"frame", "file", "sha256", "ms", "skipped"}, "a frame");
    EXPECT_EQ(frame["frame"], expected[i]);
    EXPECT_EQ(frame["file"], fmt::format("x_{:03}.png", expected[i]));
    EXPECT_TRUE(is_hash(frame["sha256"])) << frame;
    EXPECT_EQ(frame["sha256"], sha256(read(frame["file"])));
    EXPECT_GT(frame["ms"], 0.0);
    EXPECT_EQ(frame["skipped"], false);
  }
}

TEST_F(JsonOutput, Parity) {
  const Json json = this->json({"parity", arm_scene, "--frames", "0-40:10", "--tolerance", "1e-4"});
  expect_keys(json,
              {"device", "frames", "vertices", "max_position_error", "rms_position_error", "max_normal_error_degrees",
               "bbox_diagonal", "relative_error", "tolerance", "pass"},
              "parity");
  expect_device(json["device"]);
  EXPECT_EQ(json["frames"], 5);
  EXPECT_EQ(json["tolerance"], 1e-4);
  EXPECT_EQ(json["pass"], true);
  const double largest = json["max_position_error"], rms = json["rms_position_error"], box = json["bbox_diagonal"];
  EXPECT_GT(largest, 0.0) << "a compute pass in single precision that is exactly the reference was not compared";
  EXPECT_LE(rms, largest);
  EXPECT_DOUBLE_EQ(json["relative_error"], largest / box);
}

TEST_F(JsonOutput, InfoOnAModel) {
  const Json json = this->json({"info", arm()});
  expect_keys(json,
              {"vertices", "triangles", "joints", "max_influences", "clips", "humanoid", "morph_targets", "muscles",
               "bounds", "problems"},
              "info");
  for (const char* count : {"vertices", "triangles", "joints", "max_influences"}) EXPECT_GT(json[count], 0) << count;
  EXPECT_EQ(json["humanoid"]["leftLowerArm"], "leftLowerArm");
  for (const char* list : {"clips", "muscles", "problems"}) EXPECT_TRUE(json[list].is_array()) << list;
  EXPECT_FALSE(json.contains("characters")) << "a bare model is no scene";
}

TEST_F(JsonOutput, InfoOnAScene) {
  const Json json = this->json({"info", std::string(SINEW_SOURCE_DIR) + "/scenes/arm.json"});
  expect_keys(json, {"vertices", "triangles", "joints", "clips", "humanoid", "muscles", "characters", "frames", "fps"},
              "info on a scene");
  EXPECT_EQ(json["characters"], 1);
  EXPECT_EQ(json["frames"], Json({0, 47}));
  EXPECT_EQ(json["fps"], 24.0);
  ASSERT_EQ(json["muscles"].size(), 1u);
  const Json& muscle = json["muscles"][0];
  expect_keys(muscle,
              {"name", "bone", "child", "driver", "tip", "facing", "from", "to", "spread", "peak", "sigma",
               "rest_angle", "reference_angle", "on", "centre", "region_vertices", "segment_vertices"},
              "a muscle");
  EXPECT_EQ(muscle["name"], "biceps_left");
  EXPECT_GT(muscle["region_vertices"], 0);
  EXPECT_GT(muscle["segment_vertices"], muscle["region_vertices"]);
}

TEST_F(JsonOutput, InfoOnDevices) {
  const Json json = this->json({"info", "--devices"});
  expect_keys(json, {"devices"}, "info --devices");
  ASSERT_FALSE(json["devices"].empty());
  for (const Json& device : json["devices"]) expect_device(device);
}

TEST_F(JsonOutput, Export) {
  const Json counts = this->json({"info", arm()});
  const Json json = this->json({"export", arm_scene, "--frames", "0-2", "-o", "x_####.obj"});
  expect_keys(json, {"file", "frames", "vertices", "triangles"}, "export");
  EXPECT_EQ(json["file"], "x_####.obj");
  EXPECT_EQ(json["frames"], 3);
  EXPECT_EQ(json["vertices"], counts["vertices"]);
  EXPECT_EQ(json["triangles"], counts["triangles"]);
}

TEST_F(JsonOutput, Bench) {
  const Json json = this->json({"bench", arm_scene, "--frames-timed", "5", "--size", "96x64"});
  expect_keys(json, {"device",          "vertices",     "triangles",
                     "joints",          "instances",    "size",
                     "stages",          "fps",          "deform_mverts_per_s",
                     "ssd_fps",         "bulge_fps",    "bulge_cost",
                     "peak_memory_mib", "startup_ms",   "film_fps",
                     "film_cpu_ms",     "film_overlap", "png_fps",
                     "png_cpu_ms",      "png_overlap"},
              "bench");
  expect_device(json["device"]);
  EXPECT_EQ(json["size"], Json({96, 64}));
  EXPECT_EQ(json["instances"], 1);
  for (const char* stage : {"pose", "upload", "deform", "draw", "readback", "encode", "write", "film", "frame"}) {
    expect_keys(json["stages"][stage], {"median", "p95"}, stage);
    EXPECT_GT(json["stages"][stage]["median"], 0.0) << stage;
    EXPECT_GE(json["stages"][stage]["p95"], json["stages"][stage]["median"]) << stage;
  }
  for (const char* number : {"fps", "deform_mverts_per_s", "ssd_fps", "bulge_fps", "peak_memory_mib", "startup_ms"})
    EXPECT_GT(json[number], 0.0) << number;
  EXPECT_TRUE(json["bulge_cost"].is_number());
  // Of the same run: the rate over the best that its stages and its cores allow.
  const double cores = std::thread::hardware_concurrency();
  for (const auto& [kind, last] : {std::pair{"film", Arguments{"film"}}, {"png", Arguments{"encode", "write"}}}) {
    const auto number = [&](const char* key) { return json[kind + std::string(key)].get<double>(); };
    double slowest = number("_cpu_ms") / cores;
    Arguments stages{"pose", "upload", "deform", "draw", "readback"};
    stages.insert(stages.end(), last.begin(), last.end());
    for (const std::string& stage : stages) slowest = std::max(slowest, json["stages"][stage]["median"].get<double>());
    EXPECT_GT(number("_fps"), 0.0) << kind;
    EXPECT_NEAR(number("_overlap"), number("_fps") * slowest / 1000.0, 1e-9) << kind;
  }
}

TEST_F(JsonOutput, BenchLeavesNothing) {
  std::filesystem::create_directory(path("scratch"));
  const ProgramOptions options{.environment = {{"TMPDIR", path("scratch")}}};
  this->json({"bench", arm_scene, "--frames-timed", "3", "--size", "96x64"}, options);
  EXPECT_TRUE(std::filesystem::is_empty(path("scratch")));
  const ProgramResult result = run({"bench", arm_scene, "--frames-timed", "3", "--size", "96x64"},
                                   {.environment = {{"TMPDIR", path("absent")}}});
  EXPECT_EQ(result.exit_code, 7) << result;
  EXPECT_NE(result.err.find("TMPDIR"), std::string::npos) << result;
}

TEST_F(JsonOutput, BenchResamples) {
  const Json json = this->json({"bench", arm_scene, "--frames-timed", "1", "--size", "32x32", "--vertices", "20000"});
  // "about N": subdivision alone could only offer some four times the vertices or as many.
  EXPECT_NEAR(json["vertices"].get<double>(), 20000.0, 1000.0);
}

TEST_F(JsonOutput, Compare) {
  ASSERT_EQ(run({"render", arm_scene, "--size", "64x64", "-o", "x.png"}).exit_code, 0);
  const Json json = this->json({"compare", "x.png", "x.png", "--pixels", "0.25"});
  expect_keys(json, {"metric", "value", "threshold", "pixels_over", "pass"}, "compare");
  EXPECT_EQ(json["value"], 0.0);
  EXPECT_EQ(json["threshold"], 0.25);
  EXPECT_EQ(json["pixels_over"], 0);
  EXPECT_EQ(json["pass"], true);
}

TEST_F(JsonOutput, StaysAloneOnStdoutWhateverIsLogged) {
  for (const char* log :
       {"--quiet", "--verbose", "--progress=plain", "--progress=bar", "--progress=none", "--validate"}) {
    const ProgramResult result =
        run({"render", arm_scene, "--frames", "0-3", "--size", "64x64", "-o", "x_##.png", "--json", log});
    EXPECT_EQ(result.exit_code, 0) << result;
    EXPECT_EQ(json_of(result)["frames"].size(), 4u) << log;
  }
}

TEST_F(JsonOutput, WithoutTheFlagStdoutIsEmpty) {
  EXPECT_EQ(run({"render", arm_scene, "--size", "64x64", "-o", "x.png"}).out, "");
  EXPECT_EQ(run({"parity", arm_scene, "--frame", "0"}).out, "");
  EXPECT_EQ(run({"export", arm_scene, "-o", "x.obj"}).out, "");
  EXPECT_EQ(run({"compare", "x.png", "x.png"}).out, "");
}

}  // namespace
}  // namespace sinew::test
