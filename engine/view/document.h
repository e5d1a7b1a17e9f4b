#pragma once
/// The scene that a viewer shows and edits, with every edit remembered. No Vulkan here.

#include <string>
#include <vector>

#include "engine/app/stage_parts.h"

namespace sinew {

/// What an edit touched, and so what has to be made anew to show it.
enum class Touched {
  look,     ///< camera and look alone
  poses,    ///< joints' keys, motions: the stage's bounds, nothing on the device
  muscles,  ///< numbers of muscles, of which there are as many as before
  all,      ///< characters, clips, other muscles: everything on the device
};

class Document {
 public:
  /// Spells out what a bare model has by default. Fails as spelled_out_scene() does.
  static Result<Document> create(Stage stage, const SceneOptions& options);

  const Scene& scene() const { return stage_.scene; }
  const Stage& stage() const { return stage_; }
  const SceneOptions& options() const { return options_; }

  /// Shows another scene. Edits of the same non-empty `merge` in a row, such as those of one slider being dragged, are
  /// undone together. Fails as restage() does, and then nothing has changed.
  Result<Touched> edit(Scene scene, std::string label, const std::string& merge = "");
  /// Ends a run of edits that merge.
  void seal() { merging_.clear(); }
  bool is_merging() const { return !merging_.empty(); }
  const std::string& merging() const { return merging_; }
  /// Moves the camera: saved with the scene, not undone.
  void move_camera(const Camera& camera);

  bool can_undo() const { return done_ > 0; }
  bool can_redo() const { return done_ < edits_.size(); }
  /// What undo() and redo() would take back and do again; empty where there is nothing.
  std::string undo_label() const { return can_undo() ? edits_[done_ - 1].label : ""; }
  std::string redo_label() const { return can_redo() ? edits_[done_].label : ""; }
  Result<Touched> undo();
  Result<Touched> redo();
  /// The scenes that they show, where there is something to undo or to redo.
  Scene undo_scene() const;
  Scene redo_scene() const;
  /// Takes the last edit(), undo(), redo() or set_options() back, as if it had not been: what it shows cannot be shown.
  Result<void> take_back();
  /// Another number after every change of the scene, the camera's apart.
  std::size_t revision() const { return revision_; }

  /// Parts for scenes to come, which edit() then need not make.
  void lend(StageParts parts) { sinew::lend(std::move(parts), stage_); }
  /// stage_bounds() of the stage as it is; until then those before the last edits hold.
  void set_bounds(const Bounds& bounds) { stage_.bounds = bounds; }

  /// Another deformer, bulge mode or strength, which no scene holds: not undone. Everything is to be made anew.
  void set_options(Deformer deformer, BulgeMode bulge, double strength);

  /// Has a model's file read again where no character uses it now: it has been written anew.
  void forget_spare(const std::filesystem::path& model) {
    std::erase_if(stage_.spare, [&](const StagedCharacter& known) { return known.scene.model == model; });
  }

  /// True where the scene is not what was last saved or opened; the camera does not count.
  bool is_changed() const { return done_ != saved_at_; }
  /// Writes the scene file. Fails as cannot_write.
  Result<void> save(const std::filesystem::path& file);

 private:
  struct Edit {
    std::string label;
    Scene before, after;
  };
  Document(Stage stage, SceneOptions options) : stage_(std::move(stage)), options_(std::move(options)) {}
  /// What take_back() goes back to.
  struct Before {
    Scene scene;
    SceneOptions options;
    std::size_t kept = 0;     ///< edits that stay
    std::vector<Edit> edits;  ///< after those
    std::size_t done = 0, saved_at = 0;
    std::string merging;
  };
  void remember(const Scene& scene, std::size_t kept);
  Result<Touched> show(const Scene& scene);

  Stage stage_;
  SceneOptions options_;
  std::vector<Edit> edits_;
  std::size_t done_ = 0;      ///< edits that are in force
  std::size_t saved_at_ = 0;  ///< value of done_ when the file was written
  std::string merging_;
  std::optional<Before> before_;
  std::size_t revision_ = 0;
};

/// Sets a joint's angles at a frame: the one value of a joint that rests, else a key there, between keys of its own.
void set_joint_degrees(Character& character, const std::string& joint, double frame, const Vec3& degrees);
/// The angles that the keys give it; zeros without any.
Vec3 joint_degrees(const Character& character, const std::string& joint, double frame);
/// Makes the value at a frame a key, so that others can differ from it.
void add_joint_key(Character& character, const std::string& joint, double frame);
/// Takes the key at a frame away; the last one takes the joint's track with it.
void remove_joint_key(Character& character, const std::string& joint, double frame);

/// The command line that renders what the viewer shows.
std::string render_command(const Document& document, const std::string& scene_file, int frame, int width, int height);

}  // namespace sinew
