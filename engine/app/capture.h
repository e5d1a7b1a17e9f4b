#pragma once
/// Pictures without a window: a sequence of frames to files.

#include "engine/app/figure.h"
#include "engine/core/progress.h"
#include "engine/core/task_watch.h"

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
  FigureOptions figure;
  std::string output;  ///< `x.png`, `x_####.png` for several frames, or a film: .mp4, .webm, .gif
  Shard shard;
  bool resume = false;  ///< keep a frame whose file is whole, has the right size and was made by the same recipe
  ProgressStyle progress = ProgressStyle::automatic;
  TaskWatch* watch = nullptr;  ///< counts frames; cancelled, it stops capture() as a signal does
};

struct CapturedFrame {
  int frame = 0;
  std::string file;
  std::string sha256;    ///< of the file; in a film, of the frame's pixels
  double ms = 0.0;       ///< from the pose to the file on the disk
  bool skipped = false;  ///< kept from an earlier run
};

struct CaptureReport {
  std::vector<CapturedFrame> frames;
  std::string film, film_sha256;  ///< the film's file and the hash of its bytes; empty for pictures
  std::vector<std::string> problems;
  double seconds = 0.0;      ///< from the first frame's pose to the last file under its name
  double cpu_seconds = 0.0;  ///< of all the process' threads in that time
};

/// What the options ask for, checked without opening anything. Fails as usage: unknown ending, several frames into a
/// picture's name without a run of '#', or parts of a film; as cannot_write where a film's encoder is missing.
Result<void> check_output(const CaptureOptions& options);

/// Renders the selected frames into pictures or a film. Frames are drawn one after another while those before are
/// encoded and written on threads of their own; how many never changes what is written. What killed runs of the same
/// output left half-written is removed first. Fails as cannot_write where nothing could be written or the folder has
/// gone, as frames_failed where only some pictures could (the rest is not tried after twenty failures in a row), as
/// device_failed where the device or memory gave out, and as interrupted or terminated; in each case with every written
/// picture whole and no film.
Result<CaptureReport> capture(Device& device, const Stage& stage, const CaptureOptions& options);

}  // namespace sinew
