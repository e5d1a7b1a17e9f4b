#pragma once
/// One run of the viewer, from the first scene opened to the window closed. Private to the viewer's own sources.

#include <memory>

#include "engine/app/bind_mesh.h"
#include "engine/view/edit_work.h"
#include "engine/view/file_watch.h"
#include "engine/view/film_recorder.h"
#include "engine/view/orbit_camera.h"
#include "engine/view/panels.h"
#include "engine/view/picture_tools.h"
#include "engine/view/preferences.h"
#include "engine/view/shader_reload.h"
#include "engine/view/viewer.h"
#include "engine/view/window_picture.h"

namespace sinew {

/// By its name; everything else is a model.
bool is_scene_file(const std::string& file);

/// What is shown in the window, and all that the user does with it.
class ViewerSession {
 public:
  ViewerSession(Device& device, const ViewerOptions& options)
      : device_(device), options_(options), shaders_(options.frames == 0 ? options.shaders : ShaderBuild()) {
    state_.device = device.info().name + (device.info().cpu ? " (a CPU)" : "");
    state_.save_as = "scene.json";
  }

  /// Goes on from the last run, and keeps what the next one goes on from in `file`.
  void go_on_from(const Preferences& preferences, const std::filesystem::path& file);
  Result<void> open(const SceneOptions& scene, std::vector<std::string>& problems);
  /// Shows a message.
  void tell(const std::string& message) { say(message); }
  Result<ViewerReport> run(Window& window);
  /// Keeps edits that are not saved in a file of their own, for a window that ends without asking, and says so in the
  /// log.
  void rescue();

 private:
  Result<void> show_stage(Stage stage, const SceneOptions& scene, std::vector<std::string>& problems);

  /// Everything of one opened scene; the picture points into the document, so they stay and go together.
  struct Shown {
    Document document;
    std::optional<WindowPicture> picture;
    Task<Bounds> framing;  ///< finds the box of all frames
    explicit Shown(Document opened) : document(std::move(opened)) {}
  };

  Document& document() { return shown_->document; }
  FrameMaker& maker() { return shown_->picture->maker(); }
  double aspect() const { return double(seen_.width) / std::max(1, seen_.height); }

  Result<void> make_pictures(Shown& shown, std::vector<std::string>& problems);
  Result<void> follow(Touched what);
  void take_pointer();
  void take_keys(Window& window);
  void take_key(const KeyPress& press, Window& window);
  void take_requests(Window& window);
  void take_edit(const Result<Touched>& done, const std::string& said);
  void take_edit(const ViewState::Edit& edit);
  void take_edits();
  void take_step(bool back);
  void follow_bounds(bool may_find);
  bool bounds_known() const { return !bounds_stale_ && !shown_->framing.running(); }
  void look_from(const OrbitCamera& camera);
  void choose_view(View view);
  void toggle_projection();
  void frame_joint();
  void take_photo();

  // viewer_files.cpp
  void open_beside(const std::string& file);
  void reload();
  void take_opened();
  /// What to say of a model that nothing moves; empty where there is none.
  std::string without_skin();
  bool follow_disk();
  /// False where it cannot be written, which is said.
  bool save();
  /// Edits of the scene, made or waiting to be made ready, or of the open clip.
  bool has_unsaved();
  /// Opens another file or closes the window, as it was asked for.
  void leave(Window& window);
  /// Does what the user said to state_.leaving.
  void take_leave_answer(Window& window);
  /// True where the window is to close: asks first where edits would be dropped, unless that is asked already.
  bool may_close(Window& window);
  bool is_others_file() const;
  void take_file_requests(Window& window);
  void keep_preferences(const Window& window);
  void remember(const std::string& file);

  // viewer_skin.cpp
  void start_binding();
  void follow_binding();

  // viewer_shaders.cpp
  void take_shaders();
  Result<void> use_shaders(std::shared_ptr<const ShaderSet> shaders);

  // viewer_film.cpp
  void start_recording();
  void follow_recording();
  void follow_library();
  void say(std::string message, bool is_error = false) {
    state_.message = std::move(message);
    state_.is_error = is_error;
    stale_ = true;
  }
  void say(const Error& error) { say(error.message, true); }
  Result<void> show_frame(Window& window);
  /// All that can run beside the window and be stopped.
  std::vector<WorkBeside*> works();
  /// Where in the window the picture belongs, pixels; tells the panels.
  PixelBox picture_place(double pixels_per_unit);
  Result<void> fit_picture(const PictureSize& size);
  /// True while anything runs beside the window.
  bool works_beside();

  Device& device_;
  ViewerOptions options_;
  ViewState state_;
  PictureSize size_;  ///< of the window, and of photos and films; pixels
  PictureSize seen_;  ///< of the picture in the window, which fills what the panels leave
  std::unique_ptr<Shown> shown_;
  EditWork edits_;
  PictureTools tools_;
  Task<Stage> opening_;
  SceneOptions opening_options_;
  bool reloading_ = false;          ///< what is being opened is the file that is shown
  std::size_t opened_over_ = 0;     ///< Document::revision() that what is opened may take the place of
  Camera camera_in_file_;           ///< as the file was opened
  std::string opened_told_;         ///< what is said once the file that is being opened is there; empty: that it is
  bool leaves_once_saved_ = false;  ///< the user wants to save first
  bool closes_ = false;             ///< the user has agreed to it
  std::string own_file_;            ///< what was opened as a scene, or saved last: Save may replace it; empty: none
  FileWatch disk_;
  struct BoundMesh {
    AutomaticWeightReport report;
    std::vector<std::string> problems;
  };
  Task<BoundMesh> binding_;
  std::array<std::string, 2> bound_;  ///< the mesh that is bound, and the file that it becomes
  ShaderReload shaders_;
  Task<CaptureReport> recording_;
  std::string recorded_;  ///< file that it writes
  Preferences preferences_;
  std::filesystem::path preferences_file_;  ///< empty: none are kept
  bool bounds_stale_ = false;               ///< the stage's bounds are those before the last edits
  bool stale_ = true;                       ///< the picture is not that of the document any more
  int drawn_frame_ = -1;
  ViewExtras drawn_extras_;
};

}  // namespace sinew
