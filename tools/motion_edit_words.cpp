#include "tools/motion_edit_words.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "engine/core/text.h"

namespace sinew::tools {
namespace {

using Json = nlohmann::json;

struct Shape {
  const char* option;
  const char* operation;
  const char* words;  ///< what it expects
  const char* help;
};

constexpr Shape shapes[] = {
    {"--set-key", "set_key", "JOINT.AXIS@TIME=VALUE[,SLOPE]", "Give the key at a time another value, and slope"},
    {"--add-key", "add_key", "JOINT.AXIS@TIME[=VALUE[,SLOPE]]", "Make a key"},
    {"--move-key", "move_key", "JOINT.AXIS@TIME=TO", "Move a key between its neighbours"},
    {"--delete-key", "delete_key", "JOINT.AXIS@TIME", "Make one segment of the two beside a key"},
    {"--scale", "scale", "JOINT[.AXIS]=FACTOR", "Scale how far a joint goes from its first pose"},
    {"--offset", "offset", "JOINT.AXIS=DEGREES", "Turn a joint throughout"},
    {"--warp", "warp", "FACTOR", "Make it last so many times as long"},
    {"--crop", "crop", "FROM,TO", "Keep the part between two times"},
    {"--loop", "loop", "COUNT,BLEND", "Repeat it, each end blended into the begin"},
    {"--join", "join", "CLIP,BLEND", "Add another clip at the end"},
    {"--cross-fade", "cross_fade", "CLIP,FROM,TO", "Go over to another clip between two times"},
    {"--layer", "layer", "CLIP,JOINT,...", "Take joints, and all below them, from another clip"},
};

/// The part before `separator`, and the rest where it is there.
std::pair<std::string, std::optional<std::string>> cut(const std::string& text, char separator) {
  const auto at = text.find(separator);
  if (at == std::string::npos) return {text, std::nullopt};
  return {text.substr(0, at), text.substr(at + 1)};
}

bool put_number(Json& edit, const char* key, const std::string& text) {
  const auto number = parse_number(text);
  if (number) edit[key] = *number;
  return number.has_value();
}

/// "neck.x" into joint and axis; the axis may be absent where `any`.
bool put_joint(Json& edit, const std::string& text, bool any) {
  const std::size_t n = text.size();
  const bool has_axis = n > 2 && text[n - 2] == '.' && text[n - 1] >= 'x' && text[n - 1] <= 'z';
  if (!has_axis && !any) return false;
  edit["joint"] = has_axis ? text.substr(0, n - 2) : text;
  if (has_axis) edit["axis"] = std::string(1, text[n - 1]);
  return !text.empty();
}

bool put_key(Json& edit, const std::string& operation, const std::string& text) {
  const auto [place, values] = cut(text, '=');
  const auto [joint, time] = cut(place, '@');
  if (!time || !put_joint(edit, joint, false) || !put_number(edit, "time", *time)) return false;
  if (!values) return operation == "add_key" || operation == "delete_key";
  if (operation == "delete_key") return false;
  if (operation == "move_key") return put_number(edit, "to", *values);
  const auto [value, slope] = cut(*values, ',');
  return put_number(edit, "value", value) && (!slope || put_number(edit, "slope", *slope));
}

bool put_list(Json& edit, const std::string& operation, const std::string& text) {
  static const std::map<std::string, std::vector<const char*>> keys{{"warp", {"factor"}},
                                                                    {"crop", {"from", "to"}},
                                                                    {"loop", {"count", "blend"}},
                                                                    {"join", {"clip", "blend"}},
                                                                    {"cross_fade", {"clip", "from", "to"}}};
  const std::vector<std::string> parts = split(text, ',');
  if (operation == "layer") {
    if (parts.size() < 2) return false;
    edit["clip"] = parts[0];
    edit["joints"] = std::vector<std::string>(parts.begin() + 1, parts.end());
    return true;
  }
  const auto& names = keys.at(operation);
  if (parts.size() != names.size()) return false;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (std::string_view(names[i]) == "clip") {
      edit["clip"] = parts[i];
    } else if (std::string_view(names[i]) == "count") {
      const auto count = parse_integer(parts[i]);
      if (!count) return false;
      edit["count"] = *count;
    } else if (!put_number(edit, names[i], parts[i])) {
      return false;
    }
  }
  return true;
}

bool put_words(Json& edit, const std::string& operation, const std::string& text) {
  if (operation.ends_with("_key")) return put_key(edit, operation, text);
  if (operation != "scale" && operation != "offset") return put_list(edit, operation, text);
  const auto [joint, number] = cut(text, '=');
  return number && put_joint(edit, joint, operation == "scale") &&
         put_number(edit, operation == "scale" ? "factor" : "degrees", *number);
}

}  // namespace

void add_edit_options(CLI::App& command, std::deque<EditOption>& options) {
  for (const Shape& shape : shapes) {
    EditOption& added = options.emplace_back();
    added.operation = shape.operation;
    added.option = command.add_option(shape.option, added.words, fmt::format("{}: {}", shape.words, shape.help))
                       ->allow_extra_args(false);
  }
  EditOption& mirror = options.emplace_back();
  mirror.operation = "mirror";
  mirror.option = command.add_flag("--mirror", mirror.flag, "Exchange left and right");
}

Result<Json> typed_edits(const CLI::App& command, const std::deque<EditOption>& options) {
  Json edits = Json::array();
  std::map<const CLI::Option*, std::size_t> taken;
  for (const CLI::Option* typed : command.parse_order()) {
    for (const EditOption& option : options) {
      if (option.option != typed) continue;
      Json edit{{"operation", option.operation}};
      if (option.operation != "mirror") {
        const std::string& text = option.words[taken[typed]++];
        const auto* shape = std::find_if(std::begin(shapes), std::end(shapes),
                                         [&](const Shape& s) { return option.operation == s.operation; });
        if (!put_words(edit, option.operation, text))
          return failure(ErrorKind::usage, "{} {}: expected {}", shape->option, text, shape->words);
      }
      edits.push_back(std::move(edit));
    }
  }
  return edits;
}

}  // namespace sinew::tools
