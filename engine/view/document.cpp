#include "engine/view/document.h"

#include <algorithm>

#include "engine/core/files.h"
#include "engine/io/scene_file.h"
#include "engine/model/scene_words.h"
#include "engine/view/track_edit.h"

namespace sinew {
namespace {

/// How the mesh's edges are drawn, which is part of drawing the surface.
std::pair<bool, bool> wires(const Look& look) {
  const auto has = [&](Overlay wanted) { return std::ranges::find(look.overlay, wanted) != look.overlay.end(); };
  return {has(Overlay::wire), has(Overlay::wire_all)};
}

/// Muscles of the same names, in the same order, on as many characters.
bool has_same_muscles(const Character& a, const Character& b) {
  return std::ranges::equal(a.muscles, b.muscles, {}, muscle_name, muscle_name);
}

/// What differs between two scenes, at most.
Touched touched(const Scene& a, const Scene& b) {
  if (a.look.joint != b.look.joint || a.look.shading != b.look.shading || a.look.compare != b.look.compare ||
      wires(a.look) != wires(b.look))
    return Touched::all;
  if (a.fps != b.fps || a.frames != b.frames || a.characters.size() != b.characters.size()) return Touched::all;
  bool muscles = false, poses = false;
  for (std::size_t i = 0; i < a.characters.size(); ++i) {
    const Character& other = b.characters[i];
    Character one = a.characters[i];
    if (has_same_muscles(one, other)) {
      muscles = muscles || one.muscles != other.muscles;
      one.muscles = other.muscles;
    }
    if (one == other) continue;
    one.keys = other.keys;
    one.expressions = other.expressions;
    one.regions = other.regions;
    one.motion = other.motion;
    one.position = other.position;
    one.turn = other.turn;
    if (!(one == other)) return Touched::all;
    poses = true;
  }
  if (muscles && poses) return Touched::all;
  return muscles ? Touched::muscles : poses ? Touched::poses : Touched::look;
}

/// Text that a shell takes as one word.
std::string quoted(const std::string& text) {
  const bool plain = !text.empty() && std::ranges::all_of(text, [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || std::string_view("._-/:,=+#").find(c) != std::string::npos;
  });
  if (plain && text[0] != '#') return text;
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

}  // namespace

Result<Document> Document::create(Stage stage, const SceneOptions& options) {
  auto scene = spelled_out_scene(stage);
  if (!scene) return pass_on(std::move(scene));
  Document document(std::move(stage), options);
  // --pose and --clip are the scene's own from here on, or no edit could change them.
  for (const PoseOption& pose : options.poses)
    for (Character& character : scene->characters) {
      const std::size_t i = static_cast<std::size_t>(&character - scene->characters.data());
      const StagedCharacter& staged = document.stage_.characters[i];
      if (find_joint(*staged.model, staged.humanoid, pose.joint))
        character.keys[pose.joint] = Keyed<Vec3>::constant(pose.degrees);
    }
  if (options.clip)
    for (Character& character : scene->characters) character.clip = *options.clip;
  document.options_.poses.clear();
  document.options_.clip.reset();
  // What poses of the command line add to the box is found with the next edit's.
  const std::optional<Bounds> bounds = options.poses.empty() && !options.clip ? document.stage_.bounds : std::nullopt;
  if (auto ok = restage(document.stage_, *scene, document.options_); !ok) return pass_on(std::move(ok));
  document.stage_.bounds = bounds;
  return document;
}

Result<Touched> Document::show(const Scene& scene) {
  const Touched what = touched(stage_.scene, scene);
  if (what == Touched::look) {
    stage_.scene = scene;
    return what;
  }
  const std::optional<Bounds> bounds = stage_.bounds;
  const auto put = what == Touched::muscles ? restage_muscles : restage;
  if (auto ok = put(stage_, scene, options_); !ok) return pass_on(std::move(ok));
  stage_.bounds = bounds;
  return what;
}

void Document::remember(const Scene& scene, std::size_t kept) {
  const auto first = edits_.begin() + static_cast<std::ptrdiff_t>(kept);
  before_ = Before{scene, options_, kept, {first, edits_.end()}, done_, saved_at_, merging_};
  ++revision_;
}

Result<void> Document::take_back() {
  if (!before_) return {};
  Before before = *std::exchange(before_, std::nullopt);
  options_ = before.options;
  stage_.strength = options_.strength;
  const Camera camera = stage_.scene.camera;
  if (auto shown = show(before.scene); !shown) return pass_on(std::move(shown));
  stage_.scene.camera = camera;
  edits_.resize(before.kept);
  edits_.insert(edits_.end(), before.edits.begin(), before.edits.end());
  done_ = before.done;
  saved_at_ = before.saved_at;
  merging_ = before.merging;
  ++revision_;
  return {};
}

Result<Touched> Document::edit(Scene scene, std::string label, const std::string& merge) {
  if (scene == stage_.scene) return Touched::look;
  Scene before = stage_.scene;
  const bool merges = !merge.empty() && merge == merging_ && done_ > 0 && done_ == edits_.size() && done_ != saved_at_;
  auto what = show(scene);
  if (!what) return what;
  remember(before, merges ? done_ - 1 : done_);
  if (saved_at_ > done_) saved_at_ = static_cast<std::size_t>(-1);  // what was saved can no longer be come back to
  edits_.resize(done_);
  if (merges)
    edits_.back().after = std::move(scene);
  else
    edits_.push_back({std::move(label), std::move(before), std::move(scene)});
  done_ = edits_.size();
  merging_ = merge;
  return what;
}

void Document::move_camera(const Camera& camera) { stage_.scene.camera = camera; }

void Document::set_options(Deformer deformer, BulgeMode bulge, double strength) {
  remember(stage_.scene, edits_.size());
  options_.deformer = deformer;
  options_.bulge = bulge;
  options_.strength = stage_.strength = strength;
}

Scene Document::undo_scene() const {
  Scene scene = can_undo() ? edits_[done_ - 1].before : stage_.scene;
  scene.camera = stage_.scene.camera;
  return scene;
}

Scene Document::redo_scene() const {
  Scene scene = can_redo() ? edits_[done_].after : stage_.scene;
  scene.camera = stage_.scene.camera;
  return scene;
}

Result<Touched> Document::undo() {
  if (!can_undo()) return Touched::look;
  const Scene now = stage_.scene;
  auto what = show(undo_scene());
  if (!what) return what;
  remember(now, edits_.size());
  --done_;
  merging_.clear();
  return what;
}

Result<Touched> Document::redo() {
  if (!can_redo()) return Touched::look;
  const Scene now = stage_.scene;
  auto what = show(redo_scene());
  if (!what) return what;
  remember(now, edits_.size());
  ++done_;
  merging_.clear();
  return what;
}

Result<void> Document::save(const std::filesystem::path& file) {
  if (auto ok = write_file(file, scene_text(stage_.scene, file.parent_path())); !ok) return ok;
  saved_at_ = done_;
  merging_.clear();
  return {};
}

void set_joint_degrees(Character& character, const std::string& joint, double frame, const Vec3& degrees) {
  const auto [track, is_new] = character.keys.try_emplace(joint, Keyed<Vec3>::constant(degrees));
  if (!is_new) set_value(track->second, frame, degrees);
}

Vec3 joint_degrees(const Character& character, const std::string& joint, double frame) {
  const auto track = character.keys.find(joint);
  return track == character.keys.end() ? Vec3(0.0) : track->second.value_at(frame);
}

void add_joint_key(Character& character, const std::string& joint, double frame) {
  const auto [track, is_new] = character.keys.try_emplace(joint, Keyed<Vec3>::constant(Vec3(0.0)));
  if (is_new)
    track->second.keys.front().frame = frame;
  else
    put_key(track->second, frame, track->second.value_at(frame));
}

void remove_joint_key(Character& character, const std::string& joint, double frame) {
  const auto track = character.keys.find(joint);
  if (track != character.keys.end() && remove_key(track->second, frame)) character.keys.erase(track);
}

std::string render_command(const Document& document, const std::string& scene_file, int frame, int width, int height) {
  const SceneOptions& options = document.options();
  std::string text = "sinew render " + quoted(scene_file);
  if (options.deformer != Deformer::ssd) text += fmt::format(" --deformer {}", deformer_name(options.deformer));
  if (options.bulge != BulgeMode::on) text += fmt::format(" --bulge {}", bulge_name(options.bulge));
  if (options.strength != 1.0) text += fmt::format(" --strength {}", options.strength);
  if (!options.library.empty()) text += " --library " + quoted(options.library.string());
  return text + fmt::format(" --frame {} --size {}x{} -o picture.png", frame, width, height);
}

}  // namespace sinew
