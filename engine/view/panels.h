#pragma once
/// The viewer's panels, over the picture. They read and change a ViewState; what they ask for is carried out after the
/// frame.

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/gpu/device.h"
#include "engine/view/document.h"
#include "engine/view/face_picture.h"
#include "engine/view/interface_changes.h"
#include "engine/view/listed_joints.h"
#include "engine/view/motion_panel.h"
#include "engine/view/playback.h"
#include "engine/view/skin_panel.h"
#include "engine/view/task.h"
#include "engine/view/window_picture.h"

namespace sinew {

/// What the panels show and what the user did in them.
struct ViewState {
  Playback playback;
  std::string joint;                        ///< ListedJoint::name of the joint that is chosen; empty: none
  std::size_t character = 0;                ///< whose
  bool show_joint = false;                  ///< the list is to scroll to it: it was chosen in the picture
  bool gizmo = true;                        ///< the chosen joint has rings that turn it
  bool reach = false;                       ///< hands and feet have handles
  ViewExtras extras;                        ///< of the picture
  std::optional<MuscleNumber> kept_muscle;  ///< whose region stays shown
  std::array<std::string, 2> compared;      ///< names of a comparison's sides; empty: the scene compares nothing
  std::string filter;                       ///< joints whose names hold this
  bool panels = true;                       ///< shown; Tab hides them
  bool help = false;
  std::string file;     ///< what is open
  std::string save_as;  ///< name in the save field
  std::string message;  ///< of the last thing done, or what went wrong
  bool is_error = false;
  std::string device;  ///< name, and that it is a CPU
  double frames_a_second = 0.0;
  std::vector<CharacterState> states;   ///< [characters] of the frame that is shown
  std::optional<HeadSpec> wanted_head;  ///< of the chosen character, that is being drawn
  std::vector<DockedPanel> docked;      ///< that were drawn, in units
  PixelBox picture;                     ///< what they left to the picture in the frame before, likewise
  MotionPanel motion;
  SkinPanel skin;

  // Files: viewer_files.cpp.
  std::filesystem::path folder;             ///< where a file was last opened or saved
  std::vector<std::string> recent;          ///< files, the last opened first
  std::string open_field;                   ///< name in the open field
  bool changed_on_disk = false;             ///< the scene's file is newer than the edits that are shown
  std::string film;                         ///< name in the record field
  bool records = false;                     ///< a film is being recorded
  bool replacing = false, replace = false;  ///< the user is asked whether a file may be replaced; the answer is yes
  bool reload = false, record = false, toggle_projection = false;

  /// What would drop edits that are not saved: another file is opened, or the window closed.
  struct Leaving {
    std::string file;    ///< empty: closed
    bool shown = false;  ///< the question has been seen
  };
  std::optional<Leaving> leaving;  ///< the user is asked about it
  enum class LeaveAnswer { none, save, drop, stay } leave_answer = LeaveAnswer::none;

  /// A handle of the face that is being dragged, and all as it was before.
  struct FaceDrag {
    FaceHandle handle;
    ShownFace face;
    Scene scene;
    Vec2 from{0.0};  ///< of the pointer, pixels
  };
  std::optional<FaceDrag> face_drag;
  std::map<std::string, TargetAbilities> target_faces;  ///< of models by their hashes, as far as they were shown

  /// An edit of the scene that a panel made.
  struct Edit {
    Scene scene;
    std::string label, merge;
  };
  std::optional<Edit> edit;
  bool edit_ended = false;  ///< the slider was let go
  bool undo = false, redo = false, save = false, copy_command = false, screenshot = false, frame_all = false,
       frame_joint = false;
  std::optional<View> view;             ///< one of the standard views was asked for
  std::optional<SceneOptions> options;  ///< deformer, bulge or strength were changed
  std::optional<std::string> open;      ///< another file

  /// The open clip, where its edits are what was done last.
  ClipEditor* edited_clip() {
    ClipEditor* clip = motion.browser.editor();
    return motion.edited_last && clip != nullptr && clip->is_edited() ? clip : nullptr;
  }

  void tell(const Error& error) {
    message = error.message;
    is_error = true;
  }
  void tell(const Result<void>& done) {
    if (!done) tell(done.error());
  }
  void ask(Scene scene, std::string label, std::string merge = "") {
    edit = Edit{std::move(scene), std::move(label), std::move(merge)};
  }
};

/// Colours and spacing of the interface.
void set_style();

/// Draws all panels for this frame.
void draw_panels(const Document& document, ViewState& state);

/// What runs beside the window, each with its progress and a way to stop it, over the picture's lower edge.
void draw_works(std::span<WorkBeside* const> works, const ViewState& state);

}  // namespace sinew
