#pragma once
#include <string>

#include "engine/app/figure.h"

namespace sinew {

/// Everything that a picture depends on, as a hash that is stored in it: scene, frame, options and program version; not
/// where it is written, in which part of a sequence, on which device or when.
class Recipe {
 public:
  /// `figure`: FigureMaker::recipe().
  Recipe(const Stage& stage, const SceneOptions& scene, const LookOptions& look, const std::string& figure);

  /// SHA-256, 64 hexadecimal digits.
  std::string hash(int frame) const;

  static constexpr const char* png_keyword = "sinew-recipe";

 private:
  std::string text_;
};

}  // namespace sinew
