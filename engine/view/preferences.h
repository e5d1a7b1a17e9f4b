#pragma once
/// What the viewer remembers from run to run. No Vulkan here.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/app/options.h"

namespace sinew {

struct Preferences {
  PictureSize window;
  bool panels = true;               ///< shown
  bool motion_panel = false;        ///< shown
  std::filesystem::path folder;     ///< where a file was last opened or saved; empty: nowhere yet
  std::vector<std::string> recent;  ///< files, the last opened first

  /// Puts a file first, once; at most `most_recent` stay.
  void remember(const std::filesystem::path& file);
  static constexpr std::size_t most_recent = 10;

  bool operator==(const Preferences&) const = default;
};

/// $XDG_CONFIG_HOME/sinew/view.json, else ~/.config/sinew/view.json; empty where neither is known.
std::filesystem::path preferences_file();

/// The defaults where there is no file. Fails as bad_input, with the place in the file, where it cannot be read.
Result<Preferences> load_preferences(const std::filesystem::path& file);

/// Makes the folder. Fails as cannot_write.
Result<void> save_preferences(const Preferences& preferences, const std::filesystem::path& file);

}  // namespace sinew
