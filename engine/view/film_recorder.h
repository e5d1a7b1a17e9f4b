#pragma once
/// Records what a viewer shows into a film or picture, as `sinew render` does, beside the window.

#include "engine/app/capture.h"
#include "engine/gpu/device.h"
#include "engine/view/task.h"

namespace sinew {

struct Recording {
  Scene scene;
  std::string source;    ///< where its paths come from, for messages
  SceneOptions options;  ///< deformer, bulge, strength, library; its frames select, its scene counts not
  LookOptions look;
  std::string output;  ///< as CaptureOptions::output
  /// Of the device that draws it: one of its own, since a device serves one thread.
  DeviceOptions device;
};

/// Stages the scene anew and captures it. Fails as restage(), Device::create() and capture() do, as interrupted where
/// it was cancelled, and as check_failed where the validation layer said anything.
Result<CaptureReport> record(const Recording& recording, TaskWatch& watch);

}  // namespace sinew
