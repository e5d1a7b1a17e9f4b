#include "engine/app/bench.h"

#include <sys/resource.h>
#include <unistd.h>

#include <ctime>
#include <fstream>
#include <set>
#include <sstream>

#include "engine/app/bench_capture.h"
#include "engine/app/bench_face.h"
#include "engine/app/bench_timing.h"
#include "engine/app/device_state.h"
#include "engine/core/files.h"
#include "engine/core/interrupt.h"
#include "engine/io/png.h"

namespace sinew {
namespace {

/// Drivers compile shaders at first use, and caches fill.
constexpr int warm_up_rounds = 5;

/// Since this process was started, as the kernel counts it (in hundredths of a second).
double process_age_ms() {
  std::ifstream in("/proc/self/stat");
  std::string text((std::istreambuf_iterator<char>(in)), {});
  const std::size_t after_name = text.rfind(')');
  if (after_name == std::string::npos) return 0.0;
  std::istringstream fields(text.substr(after_name + 1));
  std::string skipped;
  for (int i = 0; i < 19; ++i) fields >> skipped;
  double start_ticks = 0.0;
  fields >> start_ticks;
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  const double start_ms = start_ticks * 1000.0 / double(sysconf(_SC_CLK_TCK));
  return double(now.tv_sec) * 1000.0 + double(now.tv_nsec) / 1e6 - start_ms;
}

double peak_memory_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024.0;
}

std::size_t joint_count(const Stage& stage) {
  std::size_t sum = 0;
  for (const StagedCharacter& character : stage.characters) {
    std::set<int> nodes;
    for (const Skin& skin : character.model->skins) nodes.insert(skin.joints.begin(), skin.joints.end());
    sum += nodes.size();
  }
  return sum;
}

/// The pieces that are timed, and what they took.
class Bench {
 public:
  Bench(Device& device, const Stage& stage, const BenchOptions& options, CaptureBench captures, FrameMaker with,
        FrameMaker without, std::vector<GpuDeformer> bare, std::optional<FaceBench> face)
      : device_(device),
        stage_(stage),
        options_(options),
        captures_(std::move(captures)),
        with_(std::move(with)),
        without_(std::move(without)),
        bare_(std::move(bare)),
        face_bench_(std::move(face)) {}

  Result<BenchReport> run(double startup_ms) {
    const int rounds = warm_up_rounds + options_.frames_timed;
    Progress progress("timing", static_cast<std::size_t>(rounds), options_.progress);
    for (int i = 0; i < rounds; ++i) {
      if (auto ok = check_interrupt(); !ok) return pass_on(std::move(ok));
      if (auto ok = round(i); !ok) return pass_on(std::move(ok));
      if (i + 1 == warm_up_rounds) forget();
      progress.advance();
    }
    BenchReport r = report(startup_ms);
    if (auto ok = capture_frames(r); !ok) return pass_on(std::move(ok));
    return r;
  }

 private:
  int frame_of(int i) const {
    const int length = stage_.range.last - stage_.range.first + 1;
    // A stride that is odd and long visits the whole range early, the strongly flexed end included.
    return stage_.range.first + static_cast<int>((static_cast<long long>(i) * 29) % length);
  }

  Result<void> round(int i) {
    const int frame = frame_of(i);
    std::vector<CharacterState> states;
    pose_.push_back(milliseconds([&] { states = with_.pose(frame); }));
    Result<void> uploaded;
    upload_.push_back(milliseconds([&] { uploaded = with_.upload(states); }));
    for (std::size_t c = 0; c < bare_.size() && uploaded; ++c)
      uploaded = load_state(stage_.characters[c], states[c], bare_[c]);
    if (!uploaded) return uploaded;
    if (auto ok = time_deform(i); !ok) return ok;
    if (face_bench_)
      if (auto ok = face_bench_->round(i, stage_, states); !ok) return ok;

    Result<void> ok;
    const Shot shot = with_.shot(frame);
    draw_.push_back(milliseconds([&] { ok = with_.renderer().draw_only(shot); }));
    if (!ok) return ok;
    Picture picture;
    readback_.push_back(milliseconds([&] {
      ok = with_.renderer().copy_only();
      picture = with_.renderer().picture();
    }));
    if (!ok) return ok;
    Result<Bytes> png;
    encode_.push_back(milliseconds([&] { png = encode_png(picture.rgba, picture.width, picture.height, {}, false); }));
    if (!png) return pass_on(std::move(png));
    write_.push_back(milliseconds([&] { ok = write_file(captures_.file("stage.png"), *png); }));
    if (!ok) return ok;
    const auto whole = milliseconds([&] {
      if (auto drawn = with_.picture(frame); !drawn) ok = pass_on(std::move(drawn));
    });
    frame_.push_back(whole);
    if (!ok) return ok;
    return time_pair(i, frame, shot);
  }

  /// Frames into files, and how near that comes to what the stages allow.
  Result<void> capture_frames(BenchReport& r) {
    auto film = captures_.film_stage(with_, stage_);
    if (!film) return pass_on(std::move(film));
    r.film = *film;
    auto film_capture = captures_.run(device_, stage_, "film.mp4", slowest_stage(r, r.film));
    if (!film_capture) return pass_on(std::move(film_capture));
    r.film_capture = *film_capture;
    const Timing& last = r.encode.median > r.write.median ? r.encode : r.write;
    auto png_capture = captures_.run(device_, stage_, "frame_########.png", slowest_stage(r, last));
    if (!png_capture) return pass_on(std::move(png_capture));
    r.png_capture = *png_capture;
    return {};
  }

  /// The full pass and the bare kernel, one after the other; which comes first alternates.
  Result<void> time_deform(int i) {
    Result<void> ok;
    const auto full = [&] { deform_.push_back(milliseconds([&] { ok = with_.renderer().deform(); })); };
    const auto bare = [&] {
      deform_bare_.push_back(milliseconds([&] {
        for (GpuDeformer& deformer : bare_)
          if (ok) ok = deformer.run();
      }));
    };
    if (i % 2 == 0) full();
    if (ok) bare();
    if (ok && i % 2 != 0) full();
    return ok;
  }

  /// A whole frame with the bulge and one without, both without shadows, as the rates that it is told by are.
  Result<void> time_pair(int i, int frame, Shot shot) {
    shot.shadows = false;
    shot.floor.reset();
    Result<Picture> picture;
    const auto with = [&] { with_ms_.push_back(milliseconds([&] { picture = with_.picture(frame, shot); })); };
    const auto without = [&] { without_ms_.push_back(milliseconds([&] { picture = without_.picture(frame, shot); })); };
    if (i % 2 == 0) with();
    if (picture) without();
    if (picture && i % 2 != 0) with();
    if (!picture) return pass_on(std::move(picture));
    return {};
  }

  void forget() {
    for (auto* times : {&pose_, &upload_, &deform_, &deform_bare_, &draw_, &readback_, &encode_, &write_, &frame_,
                        &with_ms_, &without_ms_})
      times->clear();
    if (face_bench_) face_bench_->forget();
  }

  BenchReport report(double startup_ms) const {
    BenchReport r;
    r.vertices = stage_.vertices();
    r.triangles = stage_.triangles();
    r.joints = joint_count(stage_);
    r.instances = stage_.characters.size();
    r.pose = timing(pose_);
    r.upload = timing(upload_);
    r.deform = timing(deform_);
    r.deform_bare = timing(deform_bare_);
    r.draw = timing(draw_);
    r.readback = timing(readback_);
    r.encode = timing(encode_);
    r.write = timing(write_);
    r.frame = timing(frame_);
    std::vector<double> ratios, costs;
    for (std::size_t i = 0; i < deform_.size(); ++i) ratios.push_back(deform_[i] / deform_bare_[i]);
    for (std::size_t i = 0; i < with_ms_.size(); ++i) costs.push_back(with_ms_[i] / without_ms_[i] - 1.0);
    r.deform_ratio = median(ratios);
    if (face_bench_) r.face_ms = face_bench_->median_ms();
    r.bulge_cost = median(costs);
    r.bulge_fps = 1000.0 / median(with_ms_);
    r.ssd_fps = 1000.0 / median(without_ms_);
    r.peak_memory_mib = peak_memory_mib();
    r.startup_ms = startup_ms;
    return r;
  }

  Device& device_;
  const Stage& stage_;
  const BenchOptions& options_;
  CaptureBench captures_;
  FrameMaker with_, without_;
  std::vector<GpuDeformer> bare_;
  std::optional<FaceBench> face_bench_;
  std::vector<double> pose_, upload_, deform_, deform_bare_, draw_, readback_, encode_, write_, frame_, with_ms_,
      without_ms_;
};

}  // namespace

Result<BenchReport> run_bench(Device& device, const Stage& stage, const BenchOptions& options) {
  auto captures = CaptureBench::create(options);
  if (!captures) return pass_on(std::move(captures));
  std::vector<std::string> problems;
  SceneOptions with_bulge = options.scene, without_bulge = options.scene;
  if (with_bulge.bulge == BulgeMode::off) with_bulge.bulge = BulgeMode::on;
  without_bulge.bulge = BulgeMode::off;
  auto with = FrameMaker::create(device, stage, with_bulge, options.look, problems);
  if (!with) return pass_on(std::move(with));
  if (auto first = with->picture(stage.range.first); !first) return pass_on(std::move(first));
  const double startup_ms = process_age_ms();

  auto without = FrameMaker::create(device, stage, without_bulge, options.look, problems);
  if (!without) return pass_on(std::move(without));
  std::vector<GpuDeformer> bare;
  for (const StagedCharacter& c : stage.characters) {
    auto deformer = GpuDeformer::create(device, c.mesh, c.rest, {}, {.bulge = BulgeMode::off, .bare = true});
    if (!deformer) return pass_on(std::move(deformer));
    bare.push_back(std::move(*deformer));
  }
  auto face = FaceBench::create(device, stage);
  if (!face) return pass_on(std::move(face));
  return Bench(device, stage, options, std::move(*captures), std::move(*with), std::move(*without), std::move(bare),
               std::move(*face))
      .run(startup_ms);
}

}  // namespace sinew
