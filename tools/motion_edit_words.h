#pragma once
/// Edits of a motion as options of the command line, in the order in which they were typed.

#include <deque>
#include <string>
#include <vector>

#include "tools/command.h"

namespace sinew::tools {

/// An option that edits, and the words that it was given.
struct EditOption {
  std::string operation;  ///< as in JSON
  CLI::Option* option = nullptr;
  std::vector<std::string> words;
  bool flag = false;
};

/// Adds --set-key, --scale and so on to a command. The list outlives the parsing.
void add_edit_options(CLI::App& command, std::deque<EditOption>& options);

/// The edits that were typed, as engine/motion/motion_edit.h takes them. Fails as usage.
Result<nlohmann::json> typed_edits(const CLI::App& command, const std::deque<EditOption>& options);

}  // namespace sinew::tools
