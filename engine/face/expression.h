#pragma once
/// Expressions: named moves of regions, mixed and held. engine/definitions.md 15; Yen 1990, 4.2.1; VRM 1.0.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/deform/face.h"

namespace sinew {

/// What an expression is shown with: several of one kind do not compete, others may be overridden.
enum class ExpressionKind { emotion, mouth, blink, look };
/// What an expression makes of another kind (VRM 1.0, VRMC_vrm expressions, override).
enum class ExpressionOverride { none, block, blend };
enum class FaceHalf { both, left, right };

/// Amounts are an adult's: for_head() makes them a head's own.
/// (The word Expression is the scene's, which has their names alone.)
struct FacePreset {
  std::string name;
  FaceChannels moves{};   ///< the thesis' own
  FaceChannels beyond{};  ///< added unless strict
  FaceChannels from{};    ///< as a shape it is the way from these to these and its moves
  ExpressionKind kind = ExpressionKind::emotion;
  ExpressionOverride mouth = ExpressionOverride::none, blink = ExpressionOverride::none,
                     look = ExpressionOverride::none;
  FaceHalf half = FaceHalf::both;  ///< as a shape

  FaceChannels channels(bool strict) const;
};

/// neutral, the thesis' expressions, VRM 1.0's presets, in the file's order.
std::span<const FacePreset> expressions();
/// Those of ARKit's 52 blend shapes that regions can make, by its names.
std::span<const FacePreset> arkit_shapes();

/// Of either list. Fails as bad_input with the nearest name.
Result<const FacePreset*> find_expression(std::string_view name);

struct WeighedExpression {
  const FacePreset* expression;
  double strength;  ///< from 0; past 1 exaggerates, up to the limits
};

/// The same with blinks, looks and mouths weakened as the others' overrides say.
std::vector<WeighedExpression> overridden(std::span<const WeighedExpression> shown);

/// The sum of the expressions' moves, blinks, looks and mouths first weakened as the others' overrides say; adult's.
FaceChannels mix_expressions(std::span<const WeighedExpression> expressions, bool strict);

/// The same moves on a head of its own size: brows and cheeks go by its eyes, lips and corners by its mouth, the drop
/// of the jaw by its height.
FaceChannels for_head(const FaceRig& face, FaceChannels channels);

/// "REGION=NUMBER" or "REGION=NUMBER,NUMBER...", as scenes name regions, added to the channels. Fails as usage where it
/// has not that form, as bad_input where there is no such region or it has another count of numbers.
Result<void> add_region(std::string_view text, FaceChannels& channels);

}  // namespace sinew
