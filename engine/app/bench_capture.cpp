#include "engine/app/bench_capture.h"

#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <thread>

#include "engine/app/bench_timing.h"
#include "engine/app/capture.h"
#include "engine/core/interrupt.h"
#include "engine/io/film.h"

namespace sinew {
namespace {

/// Pictures that are drawn before a film is timed, so that nothing is drawn beside it.
constexpr std::size_t most_film_pictures = 48, most_film_bytes = std::size_t{256} << 20;

}  // namespace

double slowest_stage(const BenchReport& stages, const Timing& last) {
  return std::max({stages.pose.median, stages.upload.median, stages.deform.median, stages.draw.median,
                   stages.readback.median, last.median});
}

void CaptureBench::RemoveFolder::operator()(const std::filesystem::path* folder) const {
  std::error_code ignored;
  std::filesystem::remove_all(*folder, ignored);
  delete folder;
}

Result<CaptureBench> CaptureBench::create(const BenchOptions& options) {
  std::error_code error;
  const std::filesystem::path among = std::filesystem::temp_directory_path(error);
  std::string name = (among / "sinew-bench-XXXXXX").string();
  if (error || ::mkdtemp(name.data()) == nullptr)
    return failure(ErrorKind::cannot_write, "{}: bench cannot make its folder there: {}; TMPDIR names another place",
                   among.string(), error ? error.message() : std::strerror(errno));
  return CaptureBench(options, Folder(new std::filesystem::path(name)));
}

std::vector<int> CaptureBench::frames(const Stage& stage) const {
  std::vector<int> numbers;
  const int length = stage.range.last - stage.range.first + 1;
  for (int i = 0; i < options_->frames_timed; ++i) numbers.push_back(stage.range.first + i % length);
  return numbers;
}

Result<Timing> CaptureBench::film_stage(FrameMaker& maker, const Stage& stage) const {
  const PictureSize& size = options_->look.size;
  const std::size_t count =
      std::clamp<std::size_t>(most_film_bytes / (std::size_t{4} * size.width * size.height), 1, most_film_pictures);
  std::vector<int> numbers = frames(stage);
  std::vector<Picture> pictures;
  for (std::size_t i = 0; i < std::min(count, numbers.size()); ++i) {
    if (auto ok = check_interrupt(); !ok) return pass_on(std::move(ok));
    auto picture = maker.picture(numbers[i]);
    if (!picture) return pass_on(std::move(picture));
    pictures.push_back(std::move(*picture));
  }
  auto film = FilmWriter::create(file("stage.mp4"), {size.width, size.height, stage.scene.fps, false});
  if (!film) return pass_on(std::move(film));
  std::vector<double> times;
  for (int i = 0; i < options_->frames_timed; ++i) {
    if (auto ok = check_interrupt(); !ok) return pass_on(std::move(ok));
    Result<void> added;
    times.push_back(milliseconds([&] { added = film->add(pictures[static_cast<std::size_t>(i) % pictures.size()]); }));
    if (!added) return pass_on(std::move(added));
  }
  return timing(std::move(times));
}

Result<Throughput> CaptureBench::run(Device& device, const Stage& stage, const char* name,
                                     double slowest_stage_ms) const {
  CaptureOptions capturing;
  capturing.scene = options_->scene;
  if (capturing.scene.bulge == BulgeMode::off) capturing.scene.bulge = BulgeMode::on;
  capturing.scene.frames = frames(stage);
  capturing.look = options_->look;
  capturing.output = file(name).string();
  capturing.progress = options_->progress;
  auto report = capture(device, stage, capturing);
  if (!report) return pass_on(std::move(report));
  const auto count = static_cast<double>(report->frames.size());
  const double cores = std::max(std::thread::hardware_concurrency(), 1u);
  Throughput result;
  result.fps = count / report->seconds;
  result.cpu_ms = 1000.0 * report->cpu_seconds / count;
  result.overlap = result.fps * std::max(slowest_stage_ms, result.cpu_ms / cores) / 1000.0;
  return result;
}

}  // namespace sinew
