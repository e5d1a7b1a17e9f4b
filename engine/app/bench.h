#pragma once
/// Time per stage, throughput, and what the bulge costs: `sinew bench`.

#include "engine/app/frame.h"
#include "engine/core/progress.h"

namespace sinew {

struct BenchOptions {
  SceneOptions scene;
  LookOptions look;
  int frames_timed = 101;  ///< rounds of every measurement; odd, so that a median is one of them
  ProgressStyle progress = ProgressStyle::automatic;
};

struct Timing {
  double median = 0.0, p95 = 0.0;  ///< milliseconds
};

/// Frames into files by capture(), everything at once.
struct Throughput {
  double fps = 0.0;      ///< from the first pose to the last file under its name
  double cpu_ms = 0.0;   ///< a frame, of all threads
  double overlap = 0.0;  ///< fps / min(1 / slowest stage, cores / CPU time a frame): 1 where nothing waits for nothing
};

struct BenchReport {
  std::size_t vertices = 0, triangles = 0, joints = 0, instances = 0;
  Timing pose, upload, deform, draw, readback, encode, frame;
  Timing write;                   ///< of an encoded PNG to the disk
  Timing film;                    ///< a picture into an .mp4, one after another with nothing beside it
  Timing deform_bare;             ///< a bare 4-influence SSD kernel of the same layout, interleaved with `deform`
  double deform_ratio = 0.0;      ///< median over rounds of deform / deform_bare
  std::optional<double> face_ms;  ///< median over interleaved rounds of what faces add to plain SSD; absent: no face
  double ssd_fps = 0.0, bulge_fps = 0.0;
  Throughput film_capture, png_capture;  ///< into an .mp4; into numbered pictures
  double bulge_cost = 0.0;               ///< median over interleaved pairs of frames of (with / without) - 1
  double peak_memory_mib = 0.0;
  double startup_ms = 0.0;  ///< from the process' start to the first picture in host memory
};

/// Every stage is timed as a submit of its own with the bulge on, after warm-up, frames taken in turn from the range;
/// then capture() makes as many frames of the range, in their order, into a film and into pictures. Files go to a
/// folder of their own among the system's temporary ones. Fails as cannot_write where that cannot be.
Result<BenchReport> run_bench(Device& device, const Stage& stage, const BenchOptions& options);

}  // namespace sinew
