#pragma once
/// Muscles as the program reports them.

#include "tools/command.h"

namespace sinew::tools {

/// The node's name, or "nodes/7" where it has none.
std::string node_name(const Model& model, int node);

/// The muscles of all characters, every number resolved. With `posed`, their angle and activation at the first frame.
nlohmann::ordered_json muscles_json(const Stage& stage, bool posed);

/// The same for people: a table, a muscle a row, a line end after each.
std::string muscle_table(const nlohmann::ordered_json& muscles);

}  // namespace sinew::tools
