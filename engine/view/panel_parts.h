#pragma once
/// The sections of the viewer's panels. ImGui's calls inside.

#include "engine/view/panels.h"

namespace sinew {

void draw_file(const Document& document, ViewState& state);
/// Asks whether a file that stands where the scene is to be saved may be replaced.
void draw_replacing(ViewState& state);
void draw_look(const Document& document, ViewState& state);
void draw_deformer(const Document& document, ViewState& state);
void draw_muscles(const Document& document, ViewState& state);
/// With its header.
void draw_skin(const Document& document, ViewState& state);
void draw_pose(const Document& document, ViewState& state);
void draw_face(const Document& document, ViewState& state);
void draw_time(const Document& document, ViewState& state);
void draw_motion(const Document& document, ViewState& state);
void draw_curves(const Document& document, ViewState& state);

/// Asks for a clip of the library as the motion of the character that is chosen.
void ask_for_clip(const Document& document, ViewState& state, const std::string& clip);

/// True where a character of the scene has a face that can be moved; one with regions, that can be drawn too.
bool has_face(const Document& document);
bool has_face_regions(const Document& document);

/// Text in so much room: what does not fit ends in "...", and the whole is told to a pointer that rests on it.
void show_fitted(const std::string& text, float width);
/// The part of a text that fits, "..." after it where that is not all.
std::string fitted_text(const std::string& text, float width);

/// Explains the item before it to a pointer that rests on it.
void show_tip(const std::string& text);

}  // namespace sinew
