#pragma once
/// Pictures against those that were looked at and kept in tests/golden, by `sinew compare`.

#include <iosfwd>

#include "tests/support/program.h"

namespace sinew::test {

struct GoldenPicture {
  std::string name;  ///< the file in tests/golden, without its ending
  Arguments arguments;
  /// Levels of 255 by which a channel may differ, in all but this share of the pixels. Shading is computed in single
  /// precision and rounded to eight bits, which drivers do differently by a level or two; and a pixel through which the
  /// silhouette passes may fall on its other side, so that all of its colour changes: 130 of these 129,600 pixels.
  int tolerance = 3;
  double pixels = 0.001;
  /// Mean FLIP: what is left where every drawn pixel, one in thirteen, is off by one level.
  double flip = 0.002;
  /// Colours of what is drawn, at least: light, texture and smooth normals make hundreds. A silhouette has one.
  std::size_t colours = 300;
  /// Of the whole picture, that what is drawn covers at most: the arm takes 0.04 to 0.1 in its scene's views.
  double covered = 0.2;
};

/// For the name of a test that fails.
std::ostream& operator<<(std::ostream& stream, const GoldenPicture& golden);

std::filesystem::path golden_file(const std::string& name);

/// The arguments of `sinew` that make a golden picture, 480x270.
Arguments render_words(const Arguments& more, const std::filesystem::path& output);

/// The scenes of scenes/FOLDER, by name and in order. Their pictures are tests/golden/FOLDER.
std::vector<std::string> scenes_of(const std::string& folder);
/// The arguments that render one of them, four samples a pixel.
Arguments scene_words(const std::string& folder, const std::string& scene, const Arguments& more = {});
/// The pictures that are kept of a folder, by name and in order.
std::vector<std::string> pictures_of(const std::string& folder);

/// What is not background: how much of the picture, and in how many colours.
struct Drawn {
  double covered = 0.0;
  std::size_t colours = 0;
};

Drawn drawn(const DecodedPng& png, bool transparent);

/// Of the whole picture, that what is drawn covers at least. An empty picture has 0, a black or filled one 1.
constexpr double least_covered = 0.03;

void expect_something_drawn(const std::filesystem::path& file, const GoldenPicture& golden);

/// Whether two pictures are told apart by the limits.
struct Judgement {
  ProgramResult pixels, flip;
  bool same() const { return pixels.exit_code == 0 && flip.exit_code == 0; }
  bool different() const { return pixels.exit_code == 1 || flip.exit_code == 1; }
};

class GoldenTest : public ProgramTest {
 protected:
  Judgement judge(const std::filesystem::path& a, const std::filesystem::path& b, const GoldenPicture& limits,
                  const std::filesystem::path& difference) const;

  /// Renders the picture and judges it by the kept one; or keeps it, where SINEW_UPDATE_GOLDENS is 1, and skips.
  void expect_is_what_it_was(const GoldenPicture& golden) const;

  /// A change that must not pass for what it was made of: were the limits too wide, it would.
  void expect_told_apart(const Arguments& original, const Arguments& changed, const GoldenPicture& limits) const;
};

}  // namespace sinew::test
