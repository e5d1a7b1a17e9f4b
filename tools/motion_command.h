#pragma once
/// What the subcommands of `sinew motion` share.

#include "engine/motion/library.h"
#include "tools/command.h"

namespace sinew::tools {

/// The words that every subcommand has.
struct MotionWords {
  CommonOptions common;
  std::string library;
};

void add_motion_options(CLI::App& command, MotionWords& words);

/// The library of `--library`, or the user's own.
Result<MotionLibrary> open_library(const MotionWords& words, bool write);

/// A clip as `motion list` has it.
nlohmann::ordered_json entry_json(const ClipEntry& entry);

/// Fails as usage where the word is no emotion; nothing is one.
Result<void> check_emotion(const std::string& emotion);

/// Fails as usage where one is empty or holds a comma.
Result<void> check_tags(const std::vector<std::string>& tags);

// The subcommands.
void add_motion_import(CLI::App& motion, Run& run);
void add_motion_list(CLI::App& motion, Run& run);
void add_motion_show(CLI::App& motion, Run& run);
void add_motion_fit(CLI::App& motion, Run& run);
void add_motion_edit(CLI::App& motion, Run& run);
void add_motion_plot(CLI::App& motion, Run& run);
void add_motion_export(CLI::App& motion, Run& run);

}  // namespace sinew::tools
