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

/// Keys by their place on a US keyboard; the number pad's numbers are numbers.
enum class KeyboardKey {
  f,
  k,
  m,
  p,
  q,
  r,
  s,
  y,
  z,
  one,
  three,
  five,
  seven,
  nine,
  space,
  tab,
  left,
  right,
  home,
  end,
  help
};

/// A key that went down, or was held long enough to count again.
struct KeyPress {
  KeyboardKey key;
  bool control = false, shift = false, again = false;
};

struct WindowOptions {
  PictureSize size;
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
  void set_title(const std::string& title);
  /// Pixels of the picture; 0 x 0 while it is minimised.
  PictureSize size() const;
  /// True where the interface's units are not the picture's pixels: places of panels mean nothing there.
  bool has_finer_pixels() const;
  /// Of the interface: 2 on a display twice as dense as usual.
  double scale() const;

  /// Takes in what the user did. `wait`: sleeps until something happens, `seconds` at most.
  void take_events(bool wait, double seconds = 1.0);
  /// True where something has happened since the last call.
  bool had_events();
  /// Keys since the last call, in their order; none that went into a text field.
  std::vector<KeyPress> take_key_presses();
  /// Files that were dropped onto the window since the last call.
  std::vector<std::filesystem::path> take_dropped_files();
  void set_clipboard(const std::string& text);

  /// Begins the interface of one frame: ImGui's calls go between this and show().
  void begin_interface();
  /// Shows the renderer's last picture for windows with the interface over it; `docked`: which panels are. A window
  /// whose size has changed shows it at the next call. Fails as device_failed where the device was lost.
  Result<void> show(const Renderer& renderer, std::span<const DockedPanel> docked);

 private:
  struct Impl;
  explicit Window(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace sinew
