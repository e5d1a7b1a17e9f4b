#pragma once
/// How fast frames become files: the part of `sinew bench` that writes.

#include <filesystem>
#include <memory>

#include "engine/app/bench.h"

namespace sinew {

/// The slowest of the stages that a file goes through, milliseconds.
double slowest_stage(const BenchReport& stages, const Timing& last);

/// Writes into a folder of its own, which is removed with it.
class CaptureBench {
 public:
  /// Fails as cannot_write. `options` must outlive it.
  static Result<CaptureBench> create(const BenchOptions& options);

  CaptureBench(CaptureBench&&) noexcept = default;

  /// A file to be written in between.
  std::filesystem::path file(const char* name) const { return *folder_ / name; }

  /// A picture into a film with nothing beside it: the first so many of the range, one after another.
  Result<Timing> film_stage(FrameMaker& maker, const Stage& stage) const;

  /// As many frames as options.frames_timed, over the range again and again, into the file or files of this name.
  Result<Throughput> run(Device& device, const Stage& stage, const char* name, double slowest_stage_ms) const;

 private:
  struct RemoveFolder {
    void operator()(const std::filesystem::path* folder) const;
  };
  using Folder = std::unique_ptr<const std::filesystem::path, RemoveFolder>;

  CaptureBench(const BenchOptions& options, Folder folder) : options_(&options), folder_(std::move(folder)) {}
  std::vector<int> frames(const Stage& stage) const;

  const BenchOptions* options_;
  Folder folder_;
};

}  // namespace sinew
