#pragma once
/// Text in less room than it needs. ImGui's calls inside.

#include <string>

namespace sinew {

/// What is kept of a text that is cut.
enum class FittedEnd { first, last };

/// The text, or as much of it as is not wider than `width` pixels, with an ellipsis at its other end.
std::string fitted_text(const std::string& text, float width, FittedEnd kept = FittedEnd::first);

/// Writes a text into what is left of the line; cut, it tells the whole to a pointer that rests on it.
void draw_fitted_text(const std::string& text, FittedEnd kept = FittedEnd::first, float width = 0.0f);

}  // namespace sinew
