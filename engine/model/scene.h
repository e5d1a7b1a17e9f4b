#pragma once
/// A scene: which models, muscles, expressions, motions, camera and look to use over which time
/// (scenes/README.md). Plain data as a file or a program states it; joint names and muscle measures are not resolved
/// yet. Frames are numbers of frames, time = frame / fps. Lengths in world units, angles in degrees.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/core/math.h"
#include "engine/model/keyed.h"

namespace sinew {

// The words for each of these, in the same order, are in scene_words.h.
enum class MuscleSide { left, right };  ///< the character's own
enum class MusclePreset { biceps, calf, triceps, forearm_flexors, quadriceps, hamstrings, deltoid, pectoral };
enum class Expression { neutral, smile, laugh, anger, surprise, shout, fear, sadness, doubt, disgust };
enum class View { front, back, left, right, top, three_quarter };
enum class Shading { lit, flat, clay, normals, weights, bulge, depth };
enum class Overlay { skeleton, bones, muscles, arrows, projection, box, axes, wire, wire_all, guides, regions };
enum class CompareWith { none, bulge, deformer, overlay };
enum class ComparisonPlace { panels, inset };
enum class MusclePlot { none, angle, profile };

/// sRGB, 8 bits a channel, not premultiplied.
struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0, alpha = 255;
  bool operator==(const Colour&) const = default;
};

/// A muscle as it is stated: what is absent comes from the preset, or where there is none from the rest pose
/// (engine/definitions.md 6 and 7). Without a preset all but driver, tip and rest_angle are there.
struct MuscleSpec {
  std::optional<MusclePreset> preset;
  std::optional<MuscleSide> side;     ///< there exactly where a preset is
  std::optional<std::string> name;    ///< absent: "biceps_left" and so on
  std::optional<std::string> bone;    ///< joint whose segment carries the muscle
  std::optional<std::string> child;   ///< joint at the segment's far end
  std::optional<std::string> driver;  ///< joint whose bending drives it; absent without a preset: `child`
  std::optional<std::string> before;  ///< joint that the driver's angle is measured from; absent: its parent
  std::optional<std::string> tip;     ///< joint beyond the driver; absent: the next on the chain
  std::optional<std::vector<std::string>> except;  ///< joints below `bone` that are not the segment's; absent: none
  std::optional<Vec3> facing;                      ///< towards the belly, any length but 0
  std::optional<double> from, to;         ///< along the segment, 0 at `bone`, 1 at `child`; within -1..2, from < to
  std::optional<double> spread;           ///< degrees to either side of `facing`, 0..180
  std::optional<double> peak;             ///< swelling at the centre at the reference angle; negative: a hollow
  std::optional<Vec2> sigma;              ///< along and across the segment, > 0
  std::optional<double> rest_angle;       ///< of the driver, degrees, 0..180; absent: measured on the rest pose
  std::optional<double> reference_angle;  ///< angle of the whole swelling, degrees, 0..180, not rest_angle
  bool on = true;                         ///< false: placed and listed, but it never swells

  bool operator==(const MuscleSpec&) const = default;
};

/// More than 1 exaggerates, up to the face's limits.
constexpr double most_expression_strength = 2.0;

/// How much of one expression; between two keys their weights cross-fade.
struct ExpressionWeight {
  Expression expression = Expression::neutral;
  double strength = 1.0;  ///< 0..most_expression_strength
  bool operator==(const ExpressionWeight&) const = default;
};

/// An expression that comes, stays and goes beside whatever else the face does: start at, run until, stop at.
struct ExpressionCue {
  std::string expression;           ///< any that the face knows, speech and blinks too; checked where the face is
  double start = 0.0;               ///< the frame from which it comes
  double until = 0.0;               ///< up to which it stays, from start on
  std::optional<double> stop = {};  ///< at which it is gone, from until on; absent: `fade` frames after it
  double fade = 6.0;                ///< frames in which it comes, >= 0; it stays at least as long as there is room for
  double strength = 1.0;            ///< 0..most_expression_strength
  Ease ease = Ease::linear;         ///< of coming and going

  bool operator==(const ExpressionCue&) const = default;
};

/// What `builtin:head` is drawn from. Names are checked where the head is made (engine/face).
struct HeadSpec {
  Keyed<double> age = Keyed<double>::constant(0);  ///< 0 (adult) to 1 (infant)
  std::map<std::string, double> skull = {};        ///< how much of each outline, 0..1
  std::map<std::string, double> measures = {};     ///< in place of what age, skull or file say
  std::optional<int> level = {};                   ///< of subdivision, 0..most_head_level; absent: the default
  std::filesystem::path file = {};                 ///< a head's file of measures, in place of an age; empty: none

  bool operator==(const HeadSpec&) const = default;
};
constexpr int default_head_level = 2, most_head_level = 4;

/// Asks for a motion clip with this tag and the expression of that name, their apexes at `frame`.
struct EmotionCue {
  double frame = 0.0;
  Expression emotion = Expression::neutral;
  double strength = 1.0;  ///< 0..1
  bool operator==(const EmotionCue&) const = default;
};

/// "none": no animation of the model's own.
struct NoClip {
  bool operator==(const NoClip&) const = default;
};
/// One of the model's own animations: none, by index, or by name.
using ClipChoice = std::variant<NoClip, int, std::string>;

/// A clip of the motion library, by name.
struct LibraryClip {
  std::string name;
  bool operator==(const LibraryClip&) const = default;
};
/// A motion file, and which of its clips.
struct MotionFile {
  std::filesystem::path path;
  std::string clip;  ///< of a glTF file's animations; empty: the first
  bool operator==(const MotionFile&) const = default;
};
/// A clip of the library, or a motion file.
using MotionChoice = std::variant<LibraryClip, MotionFile>;

/// What `keys` do to a joint that a motion moves.
enum class KeyBlend {
  replace,  ///< turn it from its rest pose: the motion moves it no longer
  add,      ///< turn it further, from where the motion has it
};

/// A motion that a character plays.
struct MotionUse {
  MotionChoice source;
  double start = 0.0;  ///< the frame at which it begins; its first pose is held before, its last one after its end
  double speed = 1.0;  ///< > 0; 2 plays it in half its time
  Keyed<double> weight = Keyed<double>::constant(1);  ///< 0: what the clip or rest pose does; 1: the motion
  KeyBlend keys = KeyBlend::replace;

  bool operator==(const MotionUse&) const = default;
};

/// One model and all that happens to it. What moves a joint, later over earlier: rest pose, clip, motion, keys.
struct Character {
  std::filesystem::path model;                            ///< a glTF file, or a built-in model's name ("builtin:woman")
  std::optional<ClipChoice> clip;                         ///< absent: the scene does not say
  std::optional<MotionUse> motion;                        ///< absent: none
  Keyed<Vec3> position = Keyed<Vec3>::constant(Vec3(0));  ///< of the model's origin
  Keyed<double> turn = Keyed<double>::constant(0);        ///< degrees about +Y
  int count = 1;                                          ///< copies; more than 1 is refused until crowds exist
  std::vector<MuscleSpec> muscles;                        ///< no two of one muscle_name()
  std::string landmarks;  ///< gives the model a face: a landmark file, "auto": look for them; empty: none
  std::map<std::string, Keyed<Vec3>> keys;             ///< joint name -> degrees about the model's x, y, z, in turn
  std::optional<HeadSpec> head;                        ///< of builtin:head; absent: an adult's
  std::optional<Keyed<ExpressionWeight>> expressions;  ///< absent: neutral
  std::vector<ExpressionCue> cues;                     ///< beside `expressions`
  std::map<std::string, Keyed<std::vector<double>>> regions;  ///< one of face_regions() -> its numbers
  std::vector<EmotionCue> emotion;                            ///< frames strictly rising

  bool operator==(const Character&) const = default;
};

enum class Projection { perspective, orthographic };

struct Camera {
  View view = View::front;
  Projection projection = Projection::perspective;   ///< orthographic: as high as perspective at the target's distance
  Keyed<double> orbit = Keyed<double>::constant(0);  ///< degrees, counter-clockwise seen from above
  std::optional<Keyed<Vec3>> target;                 ///< absent: the centre of what the scene shows
  std::optional<Keyed<double>> distance;             ///< from the target, > 0; absent: far enough to see everything
  std::optional<double> elevation;                   ///< degrees above the level, -90..90; absent: the view's

  bool operator==(const Camera&) const = default;
};

/// Pictures of a sequence in one, row by row.
struct Grid {
  int columns = 1, rows = 1;
  bool operator==(const Grid&) const = default;
};
constexpr int most_grid_places = 400;

struct Look {
  Shading shading = Shading::lit;
  std::string joint;                          ///< whose weights Shading::weights shows; empty elsewhere
  bool shadows = true;                        ///< the key light throws shadows
  std::optional<bool> floor;                  ///< shadows fall on a floor; absent: unless the background is transparent
  Colour background{0xd8, 0xd8, 0xd8, 0xff};  ///< alpha 0: transparent

  // What a picture shows beyond the characters: engine/app/figure.h.
  std::vector<Overlay> overlay;                          ///< no two alike
  CompareWith compare = CompareWith::none;               ///< with what the picture is shown together
  ComparisonPlace compare_as = ComparisonPlace::panels;  ///< side by side, or at the lower right
  std::string zoom;                                      ///< joint or muscle that an inset shows near by; empty: none
  MusclePlot plot = MusclePlot::none;                    ///< a diagram beside the picture
  std::optional<Grid> sheet;                             ///< evenly spaced frames in one picture
  std::vector<std::string> captions;                     ///< of the sheet's pictures; absent ones: the frame

  bool operator==(const Look&) const = default;
};

/// Frames first to last, both included, 0 <= first <= last.
struct FrameSpan {
  int first = 0;
  int last = 0;
  bool operator==(const FrameSpan&) const = default;
};

struct Scene {
  double fps = 24.0;                  ///< frames a second, above 0, up to 1000
  std::optional<FrameSpan> frames;    ///< absent: as long as its clips and keys last
  std::vector<Character> characters;  ///< at least one
  Camera camera;
  Look look;
  std::optional<std::filesystem::path> library;  ///< the motion library; absent: `--library`

  bool operator==(const Scene&) const = default;
};

}  // namespace sinew
