#pragma once
/// A window that shows a renderer's pictures with an interface over them. GLFW, the swapchain and the interface's own
/// drawing stay behind this header.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/app/options.h"
#include "engine/render/renderer.h"
#include "engine/view/interface_changes.h"
#include "engine/view/keyboard.h"

namespace sinew {

/// The window system, started. There is one at a time.
class WindowSystem {
 public:
  /// Fails as no_device where there is no display.
  static Result<WindowSystem> start();
  WindowSystem(WindowSystem&& other) noexcept : running_(std::exchange(other.running_, false)) {}
  WindowSystem& operator=(WindowSystem&&) = delete;
  ~WindowSystem();

  /// What a device needs for its pictures to be shown: DeviceOptions::surface_extensions.
  std::vector<std::string> surface_extensions() const;

 private:
  WindowSystem() = default;
  bool running_ = true;
};

struct WindowOptions {
  PictureSize size;
  bool in_units = true;  ///< the size is the interface's units, larger on a dense display; else pixels
  std::string title = "Sinew";
  bool uncapped = false;  ///< frames are not held back for the display
  std::string font = "";  ///< file of the interface's font; empty: its own plain one
};

class Window {
 public:
  /// Fails as no_device where the device cannot show pictures in windows. System and device must outlive it.
  static Result<Window> create(WindowSystem& system, Device& device, const WindowOptions& options);
  Window(Window&&) noexcept;
  ~Window();

  bool is_closing() const;
  void close();
  /// Takes it back that the user closed it.
  void keep_open();
  /// Its pixels; 0 x 0 while it is minimised.
  PictureSize size() const;
  /// Pixels that one unit of the interface has: 2 on a display twice as dense as usual.
  double pixels_per_unit() const;

  /// Takes in what the user did. `wait`: sleeps until something happens, `seconds` at most.
  void take_events(bool wait, double seconds = 1.0);
  /// True where something has happened since the last call.
  bool had_events();
  /// Keys since the last call, in their order; none that went into a text field or a menu.
  std::vector<KeyPress> take_key_presses();
  /// Files that were dropped onto the window since the last call.
  std::vector<std::filesystem::path> take_dropped_files();
  void set_clipboard(const std::string& text);

  /// Begins the interface of one frame: ImGui's calls go between this and show().
  void begin_interface();
  /// Shows the renderer's last picture for windows with its upper left corner at a pixel, and the interface over it.
  /// `docked`: which panels are, in units; they cover all that the picture leaves. A window whose size has changed
  /// shows it at the next call. Fails as device_failed where the device was lost.
  Result<void> show(const Renderer& renderer, int left, int top, std::span<const DockedPanel> docked);

 private:
  struct Impl;
  explicit Window(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace sinew
