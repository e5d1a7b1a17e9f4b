#pragma once
/// Pictures without a window: a sequence of frames to files.

#include "engine/app/frame.h"
#include "engine/core/progress.h"

namespace sinew {

/// One of `count` contiguous parts of the frames, so that several machines share a sequence.
struct Shard {
  int index = 0, count = 1;
};

/// `--shard I/N`. Fails as usage.
Result<Shard> parse_shard(std::string_view text);

struct CaptureOptions {
  SceneOptions scene;
  LookOptions look;
  std::string output;   ///< `x.png`, or `x_####.png` for several frames
  Shard shard;
  bool resume = false;  ///< keep a frame whose file is whole, has the right size and was made by the same recipe
  ProgressStyle progress = ProgressStyle::automatic;
};

struct CapturedFrame {
  int frame = 0;
  std::string file;
  std::string sha256;    ///< of the file
  double ms = 0.0;       ///< from the pose to the file on the disk
  bool skipped = false;  ///< kept from an earlier run
};

struct CaptureReport {
  std::vector<CapturedFrame> frames;
  std::vector<std::string> problems;
};

/// What a file name asks for, checked without opening anything. Fails as usage: unknown ending, or several frames into a
/// name without a run of '#'.
Result<void> check_picture_name(const std::string& output, const SceneOptions& scene);

/// Renders the selected frames. Drawing a frame overlaps with encoding the one before. Fails as cannot_write where no
/// frame could be written, as frames_failed where only some could, and as interrupted or terminated with every written
/// frame whole.
Result<CaptureReport> capture(Device& device, const Stage& stage, const CaptureOptions& options);

}  // namespace sinew
