#include <system_error>

#include "engine/io/face_writer.h"
#include "engine/io/keyed_writer.h"
#include "engine/io/scene_file.h"
#include "engine/model/scene_words.h"

namespace sinew {
namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

ordered_json clip_to_json(const ClipChoice& clip) {
  if (const int* index = std::get_if<int>(&clip)) return *index;
  if (const std::string* name = std::get_if<std::string>(&clip)) return *name;
  return "none";
}

ordered_json motion_to_json(const MotionUse& use, const fs::path& folder) {
  ordered_json object = ordered_json::object();
  if (const LibraryClip* library = std::get_if<LibraryClip>(&use.source)) {
    object["clip"] = library->name;
  } else {
    const MotionFile& file = std::get<MotionFile>(use.source);
    object["file"] = path_text(file.path, folder);
    if (!file.clip.empty()) object["clip"] = file.clip;
  }
  const MotionUse defaults;
  if (use.start != defaults.start) object["start"] = json_number(use.start);
  if (use.speed != defaults.speed) object["speed"] = json_number(use.speed);
  if (use.weight != defaults.weight) object["weight"] = keyed_to_json(use.weight);
  if (use.keys != defaults.keys) object["keys"] = word(use.keys, key_blend_names());
  if (object.size() > 1) return object;
  // A name alone says it all. Without a slash a file's might read as that of a clip, and the other way round.
  const std::string name = object.front();
  if (object.contains("file")) return name.find('/') == std::string::npos ? "./" + name : name;
  const bool reads_as_path = name.find_first_of("/.") != std::string::npos;
  return reads_as_path ? object : ordered_json(name);
}

template <class T>
void write_if(ordered_json& object, const char* key, const std::optional<T>& value) {
  if (value) object[key] = to_json(*value);
}

ordered_json muscle_to_json(const MuscleSpec& muscle) {
  ordered_json object = ordered_json::object();
  if (muscle.preset) object["preset"] = word(*muscle.preset, muscle_preset_names());
  if (muscle.side) object["side"] = word(*muscle.side, side_names());
  write_if(object, "name", muscle.name);
  write_if(object, "bone", muscle.bone);
  write_if(object, "child", muscle.child);
  write_if(object, "driver", muscle.driver);
  write_if(object, "before", muscle.before);
  write_if(object, "tip", muscle.tip);
  if (muscle.except) object["except"] = *muscle.except;
  write_if(object, "facing", muscle.facing);
  write_if(object, "from", muscle.from);
  write_if(object, "to", muscle.to);
  write_if(object, "spread", muscle.spread);
  write_if(object, "peak", muscle.peak);
  write_if(object, "sigma", muscle.sigma);
  write_if(object, "rest_angle", muscle.rest_angle);
  write_if(object, "reference_angle", muscle.reference_angle);
  if (!muscle.on) object["on"] = false;
  return object;
}

ordered_json character_to_json(const Character& character, const fs::path& folder) {
  const Character defaults;
  ordered_json object{{"model", path_text(character.model, folder)}};
  if (character.clip) object["clip"] = clip_to_json(*character.clip);
  if (character.motion) object["motion"] = motion_to_json(*character.motion, folder);
  if (character.position != defaults.position) object["position"] = keyed_to_json(character.position);
  if (character.turn != defaults.turn) object["turn"] = keyed_to_json(character.turn);
  if (character.count != defaults.count) object["count"] = character.count;
  for (const MuscleSpec& muscle : character.muscles) object["muscles"].push_back(muscle_to_json(muscle));
  if (!character.keys.empty()) object["keys"] = map_to_json(character.keys);
  if (!character.landmarks.empty())
    object["landmarks"] = character.landmarks == "auto" ? "auto" : path_text(character.landmarks, folder);
  write_face(character, folder, object);
  return object;
}

ordered_json camera_to_json(const Camera& camera) {
  ordered_json object{{"view", word(camera.view, view_names())}};
  if (camera.projection != Camera{}.projection) object["projection"] = word(camera.projection, projection_names());
  if (camera.orbit != Camera{}.orbit) object["orbit"] = keyed_to_json(camera.orbit);
  if (camera.elevation) object["elevation"] = *camera.elevation;
  if (camera.target) object["target"] = keyed_to_json(*camera.target);
  if (camera.distance) object["distance"] = keyed_to_json(*camera.distance);
  return object;
}

/// What of the look makes a figure of a picture.
void write_figure(ordered_json& object, const Look& look) {
  const Look defaults;
  for (const Overlay overlay : look.overlay) object["overlay"].push_back(word(overlay, overlay_names()));
  if (look.compare != defaults.compare) object["compare"] = word(look.compare, comparison_names());
  if (look.compare_as != defaults.compare_as) object["compare_as"] = word(look.compare_as, comparison_place_names());
  if (!look.zoom.empty()) object["zoom"] = look.zoom;
  if (look.plot != defaults.plot) object["plot"] = word(look.plot, muscle_plot_names());
  if (look.sheet) object["sheet"] = ordered_json::array({look.sheet->columns, look.sheet->rows});
  if (!look.captions.empty()) object["captions"] = look.captions;
}

}  // namespace

std::string path_text(const fs::path& path, const fs::path& folder) {
  if (is_built_in_model(path.string())) return path.string();
  std::error_code failed;
  const fs::path base = folder.empty() ? fs::path(".") : folder.lexically_normal();
  fs::path relative = path.lexically_normal().lexically_relative(base);
  if (!relative.empty()) return relative.generic_string();
  const fs::path absolute = fs::absolute(path, failed);
  if (failed) return path.generic_string();
  relative = absolute.lexically_normal().lexically_relative(fs::absolute(base, failed).lexically_normal());
  return (failed || relative.empty() ? absolute : relative).generic_string();
}

std::string scene_text(const Scene& scene, const fs::path& folder) {
  ordered_json document{{"sinew", 1}, {"fps", json_number(scene.fps)}};
  if (scene.frames) document["frames"] = ordered_json::array({scene.frames->first, scene.frames->last});
  if (scene.library) document["library"] = path_text(*scene.library, folder);
  document["characters"] = ordered_json::array();
  for (const Character& character : scene.characters)
    document["characters"].push_back(character_to_json(character, folder));
  if (scene.camera != Camera{}) document["camera"] = camera_to_json(scene.camera);
  if (const Look& look = scene.look; look != Look{}) {
    document["look"] = {{"shading", word(look.shading, shading_names())},
                        {"shadows", look.shadows},
                        {"background", colour_text(look.background)}};
    if (look.floor) document["look"]["floor"] = *look.floor;
    if (!look.joint.empty()) document["look"]["joint"] = look.joint;
    write_figure(document["look"], look);
  }
  return readable_json(document);
}

}  // namespace sinew
