#include "engine/io/scene_file.h"

#include <utility>

#include "engine/core/files.h"
#include "engine/core/frame_range.h"
#include "engine/io/character_reader.h"
#include "engine/io/json_reader.h"
#include "engine/io/keyed_reader.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

void read_version(const JsonValue& root) {
  const auto version = root.require("sinew", "1, the version of the format");
  if (!version) return;
  constexpr NumberRange later{.low = 1, .above_low = true};
  if (version->is_number() && later.contains(version->number()))
    return version->error(fmt::format("written for a later version ({}), expected 1", version->number()));
  if (!version->is_number() || version->number() != 1) version->error_expected("1, the version of the format");
}

FrameSpan read_frames(const JsonValue& value) {
  if (!value.expect_list(2, 2, "[first, last]")) return {};
  const FrameSpan frames{value.item(0).integer(0, last_possible_frame), value.item(1).integer(0, last_possible_frame)};
  if (frames.first > frames.last)
    value.error(fmt::format("expected first <= last, found [{}, {}]", frames.first, frames.last));
  return frames;
}

Camera read_camera(const JsonValue& value) {
  static const std::vector<std::string> known{"view", "projection", "orbit", "elevation", "target", "distance"};
  Camera camera;
  if (!value.expect_object(known)) return camera;
  if (const auto view = value.find("view")) camera.view = static_cast<View>(view->word(view_names()));
  if (const auto projection = value.find("projection"))
    camera.projection = static_cast<Projection>(projection->word(projection_names()));
  if (const auto orbit = value.find("orbit")) camera.orbit = read_keyed_number(*orbit);
  if (const auto elevation = value.find("elevation")) camera.elevation = elevation->number({-90.0, 90.0});
  if (const auto target = value.find("target")) camera.target = read_keyed_vec3(*target);
  if (const auto distance = value.find("distance"))
    camera.distance = read_keyed_number(*distance, {.low = 0, .above_low = true});
  return camera;
}

Colour read_colour(const JsonValue& value) {
  constexpr std::string_view expected = "a colour as \"#rrggbb\", or \"transparent\"";
  const std::string text = value.text(expected);
  const auto colour = parse_colour(text);
  if (!colour) value.error_expected(expected);
  return colour.value_or(Colour{});
}

std::vector<Overlay> read_overlays(const JsonValue& value) {
  std::vector<Overlay> overlays;
  if (!value.expect_list(0, overlay_names().size(), "a list of overlays")) return overlays;
  for (std::size_t i = 0; i < value.size(); ++i) {
    const auto overlay = static_cast<Overlay>(value.item(i).word(overlay_names()));
    if (std::ranges::find(overlays, overlay) != overlays.end()) value.item(i).error("stands there twice");
    overlays.push_back(overlay);
  }
  return overlays;
}

Grid read_grid(const JsonValue& value) {
  if (!value.expect_list(2, 2, "[columns, rows]")) return {};
  const Grid grid{value.item(0).integer(1, most_grid_places), value.item(1).integer(1, most_grid_places)};
  if (grid.columns * grid.rows > most_grid_places)
    value.error(fmt::format("expected at most {} places, found {} x {}", most_grid_places, grid.columns, grid.rows));
  return grid;
}

std::vector<std::string> read_captions(const JsonValue& value) {
  std::vector<std::string> captions;
  if (!value.expect_list(1, most_grid_places, "a list of texts")) return captions;
  for (std::size_t i = 0; i < value.size(); ++i) captions.push_back(value.item(i).text("a text"));
  return captions;
}

/// What of the look makes a figure of a picture.
void read_figure(const JsonValue& value, Look& look) {
  if (const auto overlay = value.find("overlay")) look.overlay = read_overlays(*overlay);
  if (const auto compare = value.find("compare"))
    look.compare = static_cast<CompareWith>(compare->word(comparison_names()));
  if (const auto place = value.find("compare_as"))
    look.compare_as = static_cast<ComparisonPlace>(place->word(comparison_place_names()));
  if (const auto zoom = value.find("zoom")) look.zoom = zoom->text("the name of a joint or a muscle");
  if (const auto plot = value.find("plot")) look.plot = static_cast<MusclePlot>(plot->word(muscle_plot_names()));
  if (const auto sheet = value.find("sheet")) look.sheet = read_grid(*sheet);
  if (const auto captions = value.find("captions")) look.captions = read_captions(*captions);
}

Look read_look(const JsonValue& value) {
  static const std::vector<std::string> known{"shading", "joint",      "shadows", "floor", "background", "overlay",
                                              "compare", "compare_as", "zoom",    "plot",  "sheet",      "captions"};
  Look look;
  if (!value.expect_object(known)) return look;
  if (const auto shading = value.find("shading")) look.shading = static_cast<Shading>(shading->word(shading_names()));
  if (const auto joint = value.find("joint")) look.joint = joint->text("a joint's name");
  if (const auto shadows = value.find("shadows")) look.shadows = shadows->flag();
  if (const auto floor = value.find("floor")) look.floor = floor->flag();
  if (look.shading == Shading::weights && look.joint.empty())
    value.require("joint", "the joint whose weights are shown");
  if (const auto background = value.find("background")) look.background = read_colour(*background);
  read_figure(value, look);
  return look;
}

std::vector<Character> read_characters(const JsonValue& value, const fs::path& folder) {
  std::vector<Character> characters;
  if (!value.expect_list(1, value.size(), "a list of at least one character")) return characters;
  for (std::size_t i = 0; i < value.size(); ++i) characters.push_back(read_character(value.item(i), folder));
  return characters;
}

Scene read_document(const JsonValue& root, const fs::path& folder) {
  static const std::vector<std::string> known{"sinew", "fps", "frames", "library", "characters", "camera", "look"};
  Scene scene;
  if (!root.is_object()) {
    root.error_expected("an object with \"sinew\": 1");
    return scene;
  }
  // First, since in a later version's file the rest may well look wrong.
  read_version(root);
  if (!root.expect_object(known)) return scene;
  if (const auto fps = root.find("fps")) scene.fps = fps->number({.low = 0, .high = 1000, .above_low = true});
  if (const auto frames = root.find("frames")) scene.frames = read_frames(*frames);
  if (const auto library = root.find("library"))
    scene.library = resolved_path(library->text("the path of a motion library"), folder);
  if (const auto characters = root.require("characters", "a list of at least one character"))
    scene.characters = read_characters(*characters, folder);
  if (const auto camera = root.find("camera")) scene.camera = read_camera(*camera);
  if (const auto look = root.find("look")) scene.look = read_look(*look);
  return scene;
}

/// Reads no further than the first key of the top level that tells what the document is.
class Sniffer : public nlohmann::json_sax<json> {
 public:
  bool is_scene() const { return is_scene_; }

  bool null() override { return inside(); }
  bool boolean(bool) override { return inside(); }
  bool number_integer(number_integer_t) override { return inside(); }
  bool number_unsigned(number_unsigned_t) override { return inside(); }
  bool number_float(number_float_t, const string_t&) override { return inside(); }
  bool string(string_t&) override { return inside(); }
  bool binary(binary_t&) override { return inside(); }
  bool start_array(std::size_t) override { return inside() && ++depth_ <= deepest; }
  bool end_array() override { return --depth_ > 0; }
  bool start_object(std::size_t) override { return ++depth_ <= deepest; }
  bool end_object() override { return --depth_ > 0; }
  bool parse_error(std::size_t, const std::string&, const json::exception&) override { return false; }

  bool key(string_t& name) override {
    if (depth_ > 1) return true;
    is_scene_ = name == "sinew" || name == "characters";
    return !is_scene_ && name != "asset";
  }

 private:
  static constexpr std::size_t deepest = 1000;

  bool inside() const { return depth_ > 0; }

  std::size_t depth_ = 0;
  bool is_scene_ = false;
};

}  // namespace

Result<Scene> read_scene(const fs::path& file) {
  auto bytes = read_file(file, JsonLimits{}.bytes);
  if (!bytes) return pass_on(std::move(bytes));
  const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  return parse_scene(text, file.string(), file.parent_path());
}

Result<Scene> parse_scene(std::string_view text, const std::string& name, const fs::path& folder) {
  auto document = parse_json(text, name);
  if (!document) return pass_on(std::move(document));
  JsonReport report(name);
  Scene scene = read_document(JsonValue(*document, report), folder);
  if (report.error()) return tl::unexpected<Error>(*report.error());
  return scene;
}

bool looks_like_scene(std::span<const unsigned char> bytes) {
  constexpr bool whole_text = true, comments_allowed = true;
  Sniffer sniffer;
  json::sax_parse(bytes.begin(), bytes.end(), &sniffer, json::input_format_t::json, whole_text, comments_allowed);
  return sniffer.is_scene();
}

}  // namespace sinew
