#pragma once
/// The viewer: a scene in a window, to be looked at, played and edited.

#include "engine/app/frame.h"
#include "engine/gpu/device.h"
#include "engine/view/shader_reload.h"
#include "engine/view/window.h"

namespace sinew {

struct ViewerOptions {
  SceneOptions scene;
  LookOptions look;  ///< its size is the window's
  int frames = 0;    ///< shows so many frames and ends; 0: until the window is closed
  bool uncapped = false;
  bool size_given = false;   ///< else the window is as large as it was last
  DeviceOptions device;      ///< of the devices that record films beside the window
  ShaderBuild shaders = {};  ///< where shaders are compiled anew; a measured run keeps its own
};

struct ViewerReport {
  int frames = 0;
  double seconds = 0.0;                  ///< for all of them
  double median_ms = 0.0, p95_ms = 0.0;  ///< from one frame shown to the next
  PictureSize size;                      ///< when it ended
  std::vector<std::string> problems;
};

/// Opens the window and returns when it is closed. Fails as open_stage(), as no_device where there is no display, and
/// as device_failed where the device was lost.
Result<ViewerReport> view(WindowSystem& system, Device& device, const ViewerOptions& options);

}  // namespace sinew
