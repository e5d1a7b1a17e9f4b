#include <algorithm>

#include <spdlog/spdlog.h>

#include "engine/app/bench.h"
#include "engine/motion/motion_bench.h"
#include "tools/command.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  SceneWords scene;
  std::string size = "1280x720";
  std::optional<long long> vertices;
  int frames_timed = 101;
};

nlohmann::ordered_json timing_json(const Timing& t) { return {{"median", t.median}, {"p95", t.p95}}; }

nlohmann::ordered_json report_json(const BenchReport& r, const MotionBench& motion, const Device& device,
                                   const PictureSize& size) {
  nlohmann::ordered_json stages;
  const std::pair<const char*, const Timing*> rows[] = {
      {"pose", &r.pose}, {"upload", &r.upload},     {"deform", &r.deform}, {"deform_bare", &r.deform_bare},
      {"draw", &r.draw}, {"readback", &r.readback}, {"encode", &r.encode}, {"write", &r.write},
      {"film", &r.film}, {"frame", &r.frame}};
  for (const auto& [name, t] : rows) stages[name] = timing_json(*t);
  nlohmann::ordered_json json{{"device", device_json(device.info())},
                              {"vertices", r.vertices},
                              {"triangles", r.triangles},
                              {"joints", r.joints},
                              {"instances", r.instances},
                              {"size", {size.width, size.height}},
                              {"stages", stages},
                              {"fps", 1000.0 / r.frame.median},
                              {"deform_mverts_per_s", double(r.vertices) / r.deform.median / 1000.0},
                              {"deform_ratio", r.deform_ratio},
                              {"film_fps", r.film_capture.fps},
                              {"film_cpu_ms", r.film_capture.cpu_ms},
                              {"film_overlap", r.film_capture.overlap},
                              {"png_fps", r.png_capture.fps},
                              {"png_cpu_ms", r.png_capture.cpu_ms},
                              {"png_overlap", r.png_capture.overlap},
                              {"ssd_fps", r.ssd_fps},
                              {"bulge_fps", r.bulge_fps},
                              {"bulge_cost", r.bulge_cost},
                              {"pose_us", r.pose.median * 1000.0},
                              {"motion",
                               {{"fit_ms", motion.fit_ms},
                                {"fit_frames", motion.fit_frames},
                                {"fit_joints", motion.fit_joints},
                                {"pose_us", motion.pose_us},
                                {"pose_joints", motion.pose_joints}}},
                              {"peak_memory_mib", r.peak_memory_mib},
                              {"startup_ms", r.startup_ms}};
  if (r.face_ms) json["face_ms"] = *r.face_ms;
  return json;
}

Result<BenchOptions> bench_options(const Words& words) {
  BenchOptions options;
  auto scene = scene_options(words.scene);
  if (!scene) return pass_on(std::move(scene));
  options.scene = std::move(*scene);
  if (words.vertices && (*words.vertices < 3 || *words.vertices > 20'000'000))
    return failure(ErrorKind::usage, "--vertices {}: expected 3 to 20,000,000", *words.vertices);
  options.scene.vertices = static_cast<std::size_t>(words.vertices.value_or(0));
  auto size = parse_size(words.size);
  if (!size) return pass_on(std::move(size));
  options.look.size = *size;
  if (words.frames_timed < 1 || words.frames_timed > 1'000'000)
    return failure(ErrorKind::usage, "--frames-timed {}: expected 1 to 1,000,000", words.frames_timed);
  options.frames_timed = words.frames_timed;
  auto progress = progress_style(words.common);
  if (!progress) return pass_on(std::move(progress));
  options.progress = *progress;
  return options;
}

/// The characters whose frame rates the thesis gives.
bool is_of_the_thesis(const Stage& stage) {
  return std::ranges::all_of(stage.characters, [](const StagedCharacter& character) {
    return character.scene.model == "builtin:skeleton" || character.scene.model == "builtin:woman";
  });
}

void log_report(const BenchReport& r, const MotionBench& motion, const Stage& stage) {
  spdlog::info("{} vertices, {} triangles, {} joints", r.vertices, r.triangles, r.joints);
  spdlog::info(
      "pose {:.3f}, upload {:.3f}, deform {:.3f} ({:.2f} times a bare 4-influence SSD kernel, {:.3f}), draw {:.3f}, "
      "read back {:.3f}, frame {:.3f} ms (medians)",
      r.pose.median, r.upload.median, r.deform.median, r.deform_ratio, r.deform_bare.median, r.draw.median,
      r.readback.median, r.frame.median);
  spdlog::info(
      "encode {:.3f} and write {:.3f} ms a PNG, {:.3f} ms a picture of a film; end to end {:.1f} frames/s into a film "
      "(overlap {:.2f}), {:.1f} into PNGs ({:.2f})",
      r.encode.median, r.write.median, r.film.median, r.film_capture.fps, r.film_capture.overlap, r.png_capture.fps,
      r.png_capture.overlap);
  spdlog::info(
      "{:.1f} frames/s plain SSD, {:.1f} with the bulge, which costs {:.1f} %; start-up {:.0f} ms, peak {:.0f} MiB",
      r.ssd_fps, r.bulge_fps, 100.0 * r.bulge_cost, r.startup_ms, r.peak_memory_mib);
  if (r.face_ms) spdlog::info("the face adds {:.3f} ms to plain SSD", *r.face_ms);
  spdlog::info(
      "motion: {:.0f} ms to fit {} frames of {} joints within 0.5 degrees on one core; {:.1f} us to play {} joints, "
      "palette and all (ozz-animation's own figures: 1.0 to sample, 0.4 for its joints)",
      motion.fit_ms, motion.fit_frames, motion.fit_joints, motion.pose_us, motion.pose_joints);
  if (is_of_the_thesis(stage))
    spdlog::info(
        "the thesis of 2009, a character of this size: 202 to 211 frames/s plain SSD, 174 to 181 with the bulge, which "
        "cost 16 % (Core 2 Duo 2 GHz, GeForce 8600M GT, deformation on the CPU; picture size not stated)");
}

Result<void> bench(const Words& words) {
  apply_verbosity(words.common);
  auto options = bench_options(words);
  if (!options) return pass_on(std::move(options));
  auto opened = open_scene(options->scene, words.common);
  if (!opened) return pass_on(std::move(opened));
  Device& device = *opened->device;
  const Stage& stage = opened->stage;
  auto report = run_bench(device, stage, *options);
  if (!report) return pass_on(std::move(report));
  const MotionBench motion = run_motion_bench();
  log_report(*report, motion, stage);
  if (words.common.json) print_json(report_json(*report, motion, device, options->look.size));
  return check_validation(device);
}

}  // namespace

void add_bench(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("bench", "Time per stage, throughput, the cost of the bulge");
  command->footer("Example: sinew bench --vertices 86529 --json");
  auto words = std::make_shared<Words>();
  add_scene_options(*command, words->scene);
  command->add_option("--vertices", words->vertices, "Subdivide and decimate the model to about so many vertices");
  command->add_option("--size", words->size, "Picture size")->capture_default_str();
  command->add_option("--frames-timed", words->frames_timed, "Rounds of every measurement")->capture_default_str();
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return bench(*words); }; });
}

}  // namespace sinew::tools
