#include <nlohmann/json.hpp>

#include "embedded/default_scene.h"
#include "engine/app/emotion_use.h"
#include "engine/app/stage_model.h"
#include "engine/body/built_in_model.h"
#include "engine/body/headed_figure.h"
#include "engine/core/files.h"
#include "engine/core/text.h"
#include "engine/io/scene_file.h"
#include "engine/model/scene_words.h"
#include "engine/rig/clip_sampling.h"
#include "engine/rig/motion_file.h"

namespace sinew {
namespace {

constexpr std::size_t largest_scene_file = std::size_t{64} << 20;
/// Kept for undoing and redoing.
constexpr std::size_t most_spare_models = 6;

/// An error, with the place in the scene file that asked for what went wrong; a bare model has no such place.
class Place {
 public:
  Place(std::string source, bool bare_model, std::size_t character)
      : prefix_(bare_model ? "" : fmt::format("{}: /characters/{}", source, character)) {}

  template <class T>
  tl::unexpected<Error> at(const std::string& pointer, Result<T>&& failed) const {
    Error error = std::move(failed.error());
    if (!prefix_.empty()) error.message = fmt::format("{}{}: {}", prefix_, pointer, error.message);
    return tl::unexpected<Error>(std::move(error));
  }

  /// The same where the message begins with the rest of the pointer.
  template <class T>
  tl::unexpected<Error> inside(const std::string& pointer, Result<T>&& failed) const {
    Error error = std::move(failed.error());
    error.message = prefix_ + pointer + error.message;
    return tl::unexpected<Error>(std::move(error));
  }

 private:
  std::string prefix_;
};

/// A scene, and whether it was made up for a bare model, which has defaults of its own.
struct OpenedScene {
  Scene scene;
  bool bare_model = false;
  std::optional<Bytes> model_bytes = std::nullopt;  ///< of a bare model's file, which was read to see what it is
};

OpenedScene bare_model_scene(const std::string& model) {
  OpenedScene opened;
  opened.bare_model = true;
  opened.scene.characters.emplace_back().model = model;
  return opened;
}

Result<OpenedScene> open_scene(const std::string& source) {
  if (source.empty()) {
    auto scene = parse_scene(default_scene, "the embedded scene", ".");
    if (!scene) return pass_on(std::move(scene));
    return OpenedScene{std::move(*scene), false};
  }
  if (is_built_in_model(source)) return bare_model_scene(source);
  auto bytes = read_file(source);
  if (!bytes) return pass_on(std::move(bytes));
  if (bytes->size() <= largest_scene_file && looks_like_scene(*bytes)) {
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    auto scene = parse_scene(text, source, std::filesystem::path(source).parent_path());
    if (!scene) return pass_on(std::move(scene));
    return OpenedScene{std::move(*scene), false};
  }
  if (is_motion_alone(source, *bytes)) {
    OpenedScene opened = bare_model_scene("builtin:figure");
    opened.scene.characters.front().motion = MotionUse{.source = MotionFile{source, ""}};
    return opened;
  }
  OpenedScene opened = bare_model_scene(source);
  opened.model_bytes = std::move(*bytes);
  return opened;
}

/// Models that are drawn from the scene's "head": a head alone, or a figure that wears one.
Result<void> draw_head(StagedCharacter& character, double frame, const Place& place) {
  const std::string name = character.scene.model.string();
  const std::optional<HeadSpec>& spec = character.scene.head;
  if (name == "builtin:head") {
    auto head = DrawnHead::make(spec.value_or(HeadSpec{}), frame);
    if (!head) return place.inside("/head", std::move(head));
    character.face.head = std::make_shared<DrawnHead>(std::move(*head));
    character.model = std::make_unique<Model>(character.face.head->model());
    character.model_hash = fmt::format("{} {}", name, sha256(character.face.head->measures()));
    return {};
  }
  if (!spec) return {};
  const auto figure = built_in_figure(name);
  if (!figure)
    return place.at("/head",
                    Result<void>(bad_input("is for \"builtin:head\" and the built-in figures, not for {}", name)));
  if (!spec->age.is_constant())
    return place.at("/head/age",
                    Result<void>(bad_input("a figure's head keeps its age; only builtin:head changes it")));
  const auto measures = head_measures(*spec, frame);
  if (!measures) return place.inside("/head", Result<HeadMeasures>(measures));
  auto headed = build_headed_figure(*figure, *measures, spec->level.value_or(default_head_level));
  if (!headed) return place.at("/head", std::move(headed));
  character.face.worn = headed->face();
  character.model = std::make_unique<Model>(std::move(headed->model));
  character.model->file = name;
  character.model_hash =
      fmt::format("{} {} {}", name, sha256(measures_text(*measures)), spec->level.value_or(default_head_level));
  return {};
}

Result<void> choose_clip(StagedCharacter& character, const SceneOptions& options, bool bare_model, const Place& place) {
  std::optional<ClipChoice> choice = options.clip ? options.clip : character.scene.clip;
  if (!choice && bare_model && !character.model->clips.empty()) choice = 0;
  if (!choice) return {};
  auto clip = find_clip(*character.model, *choice);
  if (!clip) return options.clip ? pass_on(std::move(clip)) : place.at("/clip", std::move(clip));
  character.clip = *clip;
  return {};
}

Result<void> find_tracks(StagedCharacter& character, const Place& place) {
  for (const auto& [joint, keys] : character.scene.keys) {
    auto node = find_joint(*character.model, character.humanoid, joint);
    if (!node) return place.at("/keys/" + joint, std::move(node));
    const bool added = character.scene.motion && character.scene.motion->keys == KeyBlend::add;
    character.tracks.push_back({*node, keys, added});
  }
  return {};
}

/// --pose turns the joint of that name in every character that has it.
Result<void> add_poses(Stage& stage, const std::vector<PoseOption>& poses) {
  for (const PoseOption& pose : poses) {
    std::optional<Error> unknown;
    bool found = false;
    for (StagedCharacter& character : stage.characters) {
      const auto node = find_joint(*character.model, character.humanoid, pose.joint);
      if (!node) {
        unknown = node.error();
        continue;
      }
      character.tracks.push_back({*node, Keyed<Vec3>::constant(pose.degrees)});
      found = true;
    }
    if (!found)
      return bad_input("--pose {}: {}", pose.joint, unknown ? unknown->message : "the scene has no character");
  }
  return {};
}

PlacementContext placement_context(const StagedCharacter& character) {
  return {*character.model, character.mesh, character.rest, character.humanoid};
}

Result<void> place_muscles(StagedCharacter& character, bool bare_model, const Place& place,
                           std::vector<std::string>& problems) {
  const PlacementContext context = placement_context(character);
  if (bare_model) {
    character.muscles = default_muscles(context, problems);
    return {};
  }
  for (std::size_t i = 0; i < character.scene.muscles.size(); ++i) {
    auto placed = place_muscle(context, character.scene.muscles[i]);
    if (!placed) return place.at(fmt::format("/muscles/{}", i), std::move(placed));
    character.muscles.push_back(std::move(*placed));
  }
  return {};
}

Result<void> add_emotions(StagedCharacter& character, const SceneOptions& options, double fps, const Place& place,
                          std::vector<std::string>& problems) {
  const std::vector<EmotionCue>& cues = character.scene.emotion;
  if (cues.empty()) return {};
  auto library = MotionLibrary::open(options.library.empty() ? default_library() : options.library, false);
  if (!library) return place.at("/emotion", std::move(library));
  std::vector<EmotionSpan> spans;
  for (std::size_t i = 0; i < cues.size(); ++i) {
    auto staged = stage_emotion(cues[i], *library, fps, *character.model, character.humanoid, problems);
    if (!staged) return place.at(fmt::format("/emotion/{}", i), std::move(staged));
    character.emotions.push_back(std::move(staged->motion));
    spans.push_back(staged->span);
  }
  character.scene.expressions = expressions_with(character.scene.expressions, cues, spans);
  return {};
}

std::string named_problem(const StagedCharacter& character, const std::string& problem) {
  return fmt::format("{}: {}", character.scene.model.string(), problem);
}

/// What the scene makes of the model, which is there already.
Result<void> prepare_use(StagedCharacter& character, const SceneOptions& options, bool bare_model, double fps,
                         const Place& place, std::vector<std::string>& problems) {
  std::vector<std::string> found = character.model->problems;
  found.insert(found.end(), character.face.problems.begin(), character.face.problems.end());
  if (auto ok = choose_clip(character, options, bare_model, place); !ok) return ok;
  if (const auto& use = character.scene.motion) {
    auto motion = stage_motion(*use, options.library, *character.model, character.humanoid, found);
    if (!motion) return place.at("/motion", std::move(motion));
    character.motion = std::move(*motion);
  }
  const bool has_face_of_emotions_alone = !character.scene.emotion.empty() && !character.scene.expressions &&
                                          character.scene.cues.empty() && character.scene.regions.empty();
  if (auto ok = add_emotions(character, options, fps, place, found); !ok) return ok;
  if (auto ok = find_tracks(character, place); !ok) return ok;
  if (auto ok = stage_face(character.scene, *character.model, character.mesh, character.face); !ok) {
    if (!has_face_of_emotions_alone) return place.inside("", std::move(ok));
    found.push_back("has no face that could show its emotions; its body does");
    character.scene.expressions.reset();
  }
  if (auto ok = place_muscles(character, bare_model, place, found); !ok) return ok;
  if (character.mesh.triangles.empty()) found.push_back("has no triangles; nothing of it is shown");
  for (const PlacedMuscle& placed : character.muscles)
    for (std::string& problem : placement_problems(placed)) found.push_back(std::move(problem));
  for (const std::string& problem : found) problems.push_back(named_problem(character, problem));
  return {};
}

Result<void> prepare(StagedCharacter& character, const SceneOptions& options, double fps, OpenedScene& opened,
                     const Place& place, std::vector<std::string>& problems) {
  auto bytes = std::exchange(opened.model_bytes, std::nullopt);
  if (auto ok = stage_model(character, options, std::move(bytes)); !ok) return place.at("/model", std::move(ok));
  return prepare_use(character, options, opened.bare_model, fps, place, problems);
}

/// What of the faces is held at limits, once a channel.
void note_held(Stage& stage) {
  for (StagedCharacter& character : stage.characters) {
    character.face.held = held_over(character.face, character.mesh, stage.range.first, stage.range.last);
    for (const auto& [held, frame] : character.face.held)
      stage.problems.push_back(fmt::format("{}: {} is held at {:.4g}, asked for {:.4g} (frame {})",
                                           character.scene.model.string(), channel_word(held.channel), held.held,
                                           held.asked, frame));
  }
}

/// From frame 0 to the last frame that a clip or a key has.
FrameSpan natural_range(const Stage& stage) {
  double last = 0.0;
  const auto reach = [&](const auto& keyed) { last = std::max(last, std::ceil(keyed.keys.back().frame)); };
  const Camera& camera = stage.scene.camera;
  reach(camera.orbit);
  if (camera.target) reach(*camera.target);
  if (camera.distance) reach(*camera.distance);
  for (const StagedCharacter& character : stage.characters) {
    reach(character.scene.position);
    reach(character.scene.turn);
    // A duration that is a whole number of frames up to rounding must not grow by one.
    if (character.clip >= 0)
      last = std::max(last, std::ceil(character.model->clips[character.clip].duration * stage.scene.fps - 1e-6));
    if (character.motion) last = std::max(last, std::ceil(last_frame(*character.motion, stage.scene.fps) - 1e-6));
    for (const StagedMotion& emotion : character.emotions) reach(emotion.use.weight);
    for (const StagedCharacter::JointTrack& track : character.tracks) reach(track.degrees);
    last = std::max(last, std::ceil(reach_of(character.face.track).second));
    if (character.scene.head) reach(character.scene.head->age);
  }
  return {0, static_cast<int>(std::clamp(last, 0.0, 1e7))};
}

std::string hash_scene(const Stage& stage, const SceneOptions& options) {
  nlohmann::ordered_json json;
  Scene scene = stage.scene;
  scene.frames = stage.range;
  // Where a model lies does not change what is shown; what is in it does.
  for (std::size_t i = 0; i < scene.characters.size(); ++i) {
    scene.characters[i].model = stage.characters[i].model_hash;
    if (const auto& motion = stage.characters[i].motion)
      scene.characters[i].motion->source = LibraryClip{motion->content_hash};
  }
  json["scene"] = scene_text(scene, {});
  for (const StagedCharacter& character : stage.characters) {
    json["clips"].push_back(character.clip);
    for (const StagedMotion& emotion : character.emotions) json["emotions"].push_back(emotion.content_hash);
    for (const PlacedMuscle& placed : character.muscles) json["muscles"].push_back(placed.muscle.name);
  }
  for (const PoseOption& pose : options.poses)
    json["poses"].push_back({pose.joint, pose.degrees.x, pose.degrees.y, pose.degrees.z});
  json["strength"] = stage.strength;
  return sha256(json.dump());
}

/// What follows from the characters once all are there.
Result<void> complete(Stage& stage, const SceneOptions& options) {
  if (auto ok = add_poses(stage, options.poses); !ok) return bad_input("{}: {}", stage.source, ok.error().message);
  stage.range = stage.scene.frames.value_or(natural_range(stage));
  note_held(stage);
  stage.scene_hash = hash_scene(stage, options);
  return {};
}

bool has_model_of(const StagedCharacter& known, const Character& character) {
  return known.model && known.scene.model == character.model && known.scene.head == character.head &&
         known.scene.landmarks == character.landmarks;
}

Result<void> make_model(StagedCharacter& character, const Scene& scene, const SceneOptions& options,
                        const Place& place) {
  if (auto ok = draw_head(character, scene.frames.value_or(FrameSpan{}).first, place); !ok) return ok;
  if (auto ok = stage_model(character, options, std::nullopt); !ok) return place.at("/model", std::move(ok));
  return {};
}

}  // namespace

Result<Stage> open_stage(const SceneOptions& options) {
  auto opened = open_scene(options.scene);
  if (!opened) return pass_on(std::move(opened));
  Stage stage;
  stage.source = options.scene.empty() ? "the embedded scene" : options.scene;
  stage.scene = std::move(opened->scene);
  stage.is_scene = !opened->bare_model;
  stage.strength = options.strength;
  if (options.fps) stage.scene.fps = *options.fps;
  SceneOptions with_library = options;
  if (stage.scene.library) with_library.library = *stage.scene.library;
  for (const Character& character : stage.scene.characters) {
    const Place place(stage.source, opened->bare_model, stage.characters.size());
    StagedCharacter& staged = stage.characters.emplace_back();
    staged.scene = character;
    const double first = stage.scene.frames.value_or(FrameSpan{}).first;
    if (auto ok = draw_head(staged, first, place); !ok) return pass_on(std::move(ok));
    if (auto ok = prepare(staged, with_library, stage.scene.fps, *opened, place, stage.problems); !ok)
      return pass_on(std::move(ok));
  }
  if (auto ok = complete(stage, options); !ok) return pass_on(std::move(ok));
  return stage;
}

bool needs_model(const Stage& stage, const Character& character) {
  const auto same = [&](const StagedCharacter& known) { return has_model_of(known, character); };
  return std::ranges::none_of(stage.characters, same) && std::ranges::none_of(stage.spare, same);
}

Result<StagedCharacter> ready_character(const Scene& scene, std::size_t character, const SceneOptions& options,
                                        const std::string& source) {
  const Place place(source, false, character);
  StagedCharacter ready;
  ready.scene = scene.characters[character];
  if (auto ok = make_model(ready, scene, options, place); !ok) return pass_on(std::move(ok));
  return ready;
}

Result<void> restage(Stage& stage, const Scene& scene, const SceneOptions& options) {
  Stage next;
  next.source = stage.source;
  next.scene = scene;
  next.strength = options.strength;
  SceneOptions with_library = options;
  if (scene.library) with_library.library = *scene.library;
  std::vector<StagedCharacter*> known;
  for (std::vector<StagedCharacter>* list : {&stage.characters, &stage.spare})
    for (StagedCharacter& character : *list) known.push_back(&character);
  // Each model serves once; it goes back where it came from if the new scene cannot be staged.
  std::vector<StagedCharacter*> taken_from;
  const auto fail = [&](Error error) -> Result<void> {
    for (std::size_t i = 0; i < taken_from.size(); ++i)
      if (taken_from[i]) {
        StagedCharacter& lent = next.characters[i];
        taken_from[i]->model = std::move(lent.model);
        taken_from[i]->mesh = std::move(lent.mesh);
        taken_from[i]->rest = std::move(lent.rest);
      }
    return tl::unexpected<Error>(std::move(error));
  };
  for (const Character& character : scene.characters) {
    const Place place(stage.source, false, next.characters.size());
    StagedCharacter& staged = next.characters.emplace_back();
    staged.scene = character;
    const auto old = std::ranges::find_if(
        known, [&](const StagedCharacter* candidate) { return has_model_of(*candidate, character); });
    if (old != known.end()) {
      taken_from.push_back(*old);
      staged.model = std::move((*old)->model);
      staged.model_hash = (*old)->model_hash;
      staged.order = (*old)->order;
      staged.rest_rotations = (*old)->rest_rotations;
      staged.humanoid = (*old)->humanoid;
      staged.mesh = std::move((*old)->mesh);
      staged.rest = std::move((*old)->rest);
      staged.face.head = (*old)->face.head;
      staged.face.worn = (*old)->face.worn;
      staged.face.landmarks = (*old)->face.landmarks;
      staged.face.problems = (*old)->face.problems;
    } else {
      taken_from.push_back(nullptr);
      if (auto ok = make_model(staged, scene, with_library, place); !ok) return fail(ok.error());
    }
    if (auto ok = prepare_use(staged, with_library, false, scene.fps, place, next.problems); !ok)
      return fail(ok.error());
  }
  if (auto ok = complete(next, options); !ok) return fail(ok.error());
  for (StagedCharacter* left : known)
    if (left->model && next.spare.size() < most_spare_models) next.spare.push_back(std::move(*left));
  stage = std::move(next);
  return {};
}

Result<void> restage_muscles(Stage& stage, const Scene& scene, const SceneOptions& options) {
  std::vector<std::vector<PlacedMuscle>> placed(stage.characters.size());
  for (std::size_t c = 0; c < stage.characters.size(); ++c) {
    const StagedCharacter& character = stage.characters[c];
    const std::vector<MuscleSpec>&before = character.scene.muscles, &wanted = scene.characters[c].muscles;
    for (std::size_t m = 0; m < wanted.size(); ++m) {
      if (wanted[m] == before[m]) {
        placed[c].push_back(character.muscles[m]);
        continue;
      }
      auto muscle = place_muscle(placement_context(character), wanted[m]);
      if (!muscle) return Place(stage.source, false, c).at(fmt::format("/muscles/{}", m), std::move(muscle));
      placed[c].push_back(std::move(*muscle));
    }
  }
  for (std::size_t c = 0; c < stage.characters.size(); ++c) {
    StagedCharacter& character = stage.characters[c];
    for (const PlacedMuscle& old : character.muscles)
      for (const std::string& problem : placement_problems(old))
        std::erase(stage.problems, named_problem(character, problem));
    character.muscles = std::move(placed[c]);
    character.scene.muscles = scene.characters[c].muscles;
    for (const PlacedMuscle& muscle : character.muscles)
      for (const std::string& problem : placement_problems(muscle))
        stage.problems.push_back(named_problem(character, problem));
  }
  stage.scene = scene;
  stage.scene_hash = hash_scene(stage, options);
  return {};
}

}  // namespace sinew
