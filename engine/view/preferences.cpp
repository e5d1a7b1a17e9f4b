#include "engine/view/preferences.h"

#include <algorithm>
#include <cstdlib>

#include "engine/core/files.h"
#include "engine/io/json_reader.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

constexpr int smallest_window = 200, largest_window = 16384;
constexpr std::size_t largest_file = std::size_t{1} << 20;

PictureSize read_size(const JsonValue& value) {
  const PictureSize usual;
  if (!value.expect_list(2, 2, "[width, height]")) return usual;
  return {value.item(0).integer(smallest_window, largest_window),
          value.item(1).integer(smallest_window, largest_window)};
}

}  // namespace

void Preferences::remember(const fs::path& file) {
  std::error_code error;
  const fs::path whole = fs::absolute(file, error);
  const std::string name = (error ? file : whole.lexically_normal()).string();
  std::erase(recent, name);
  recent.insert(recent.begin(), name);
  if (recent.size() > most_recent) recent.resize(most_recent);
  folder = fs::path(name).parent_path();
}

fs::path preferences_file() {
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && *config != '\0')
    return fs::path(config) / "sinew" / "view.json";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home != '\0')
    return fs::path(home) / ".config" / "sinew" / "view.json";
  return {};
}

Result<Preferences> load_preferences(const fs::path& file) {
  std::error_code error;
  if (file.empty() || !fs::exists(file, error)) return Preferences{};
  const auto bytes = read_file(file, largest_file);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  const auto json = parse_json({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, file.string());
  if (!json) return tl::unexpected<Error>(json.error());
  static const std::vector<std::string> known{"window", "panels", "motion_panel", "folder", "recent"};
  JsonReport report(file.string());
  const JsonValue root(*json, report);
  Preferences preferences;
  if (root.expect_object(known)) {
    if (const auto window = root.find("window")) preferences.window = read_size(*window);
    if (const auto panels = root.find("panels")) preferences.panels = panels->flag();
    if (const auto motion = root.find("motion_panel")) preferences.motion_panel = motion->flag();
    if (const auto folder = root.find("folder")) preferences.folder = folder->text("a folder");
    if (const auto recent = root.find("recent"); recent && recent->expect_list(0, 1000, "a list of files"))
      for (std::size_t i = 0; i < std::min(recent->size(), Preferences::most_recent); ++i)
        preferences.recent.push_back(recent->item(i).text("a file"));
  }
  if (report.error()) return tl::unexpected<Error>(*report.error());
  return preferences;
}

Result<void> save_preferences(const Preferences& preferences, const fs::path& file) {
  if (file.empty()) return failure(ErrorKind::cannot_write, "preferences: neither XDG_CONFIG_HOME nor HOME is set");
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error)
    return failure(ErrorKind::cannot_write, "{}: its folder cannot be made: {}", file.string(), error.message());
  nlohmann::ordered_json json{{"window", {preferences.window.width, preferences.window.height}},
                              {"panels", preferences.panels},
                              {"motion_panel", preferences.motion_panel}};
  if (!preferences.folder.empty()) json["folder"] = preferences.folder.string();
  json["recent"] = preferences.recent;
  return write_file(file, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace sinew
