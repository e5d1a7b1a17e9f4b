#pragma once
/// The sections of the viewer's panels. ImGui's calls inside.

#include "engine/view/panels.h"

namespace sinew {

void draw_file(const Document& document, ViewState& state);
/// Asks whether a file that stands where the scene is to be saved may be replaced.
void draw_replacing(ViewState& state);
/// Asks about edits that are not saved: ViewState::leaving.
void draw_leaving(ViewState& state);
void draw_look(const Document& document, ViewState& state);
void draw_deformer(const Document& document, ViewState& state);
void draw_muscles(const Document& document, ViewState& state);
/// With its header.
void draw_skin(const Document& document, ViewState& state);
/// True where nothing can move a character: its file has neither skin weights nor animations.
bool stands_still(const StagedCharacter& character);
void draw_pose(const Document& document, ViewState& state);
void draw_face(const Document& document, ViewState& state);
void draw_time(const Document& document, ViewState& state);
void draw_motion(const Document& document, ViewState& state);
void draw_curves(const Document& document, ViewState& state);

/// A clip of the library as the motion of the character that is chosen; nothing where none is.
std::optional<ViewState::Edit> clip_edit(const Document& document, const ViewState& state, const std::string& clip);

/// True where a character of the scene has a face that can be moved; one with regions, that can be drawn too.
bool has_face(const Document& document);
bool has_face_regions(const Document& document);

/// True in the frame in which Escape is pressed.
bool is_escaped();

/// Explains the item before it to a pointer that rests on it.
void show_tip(const std::string& text);

}  // namespace sinew
