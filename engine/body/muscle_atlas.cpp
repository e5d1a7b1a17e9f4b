#include "engine/body/muscle_atlas.h"

#include <array>
#include <cassert>

namespace sinew {
namespace {

using enum HumanoidBone;

constexpr AtlasDriver elbow_bends[] = {{left_lower_arm, {}, 35.0}};
constexpr AtlasDriver ankle_or_knee[] = {{left_foot, {}, 150.0}, {left_lower_leg, {}, 60.0}};
constexpr AtlasDriver elbow_straightens[] = {{left_lower_arm, {}, 180.0}};
constexpr AtlasDriver wrist_or_elbow[] = {{left_hand, {}, 110.0}, {left_lower_arm, {}, 35.0}};
// From the spine, since the line from hip to pelvis' root runs across the body and hardly tells the thigh's lift.
constexpr AtlasDriver hip_or_knee[] = {{left_upper_leg, upper_chest, 80.0}, {left_lower_leg, {}, 180.0}};
constexpr AtlasDriver knee_bends[] = {{left_lower_leg, {}, 50.0}};
// From the hip of the same side: 0 with the arm hanging, 90 held out, 180 overhead, whichever way it was raised.
constexpr AtlasDriver arm_rises[] = {{left_upper_arm, left_upper_leg, 150.0}};
// From the other shoulder: 180 with the arm held out sideways, 90 forwards, less across the chest.
constexpr AtlasDriver arm_crosses[] = {{left_upper_arm, right_upper_arm, 55.0}};

constexpr std::array<AtlasMuscle, 8> atlas{{
    {MusclePreset::biceps, left_upper_arm, left_lower_arm, elbow_bends, BellySide::flexor, BellySide::front, 1.0 / 3.0,
     1.0, 75.0, 0.30, 0.20, 0.70, 0.0,
     "Shortens by about 7 cm over the elbow's range (Murray, Buchanan and Delp 2000), near linearly in its angle; 145 "
     "degrees is full flexion (AAOS). 0.30 r makes an arm 8 to 13 % thicker, as tensed arms of rowers are."},
    {MusclePreset::calf, left_lower_leg, left_foot, ankle_or_knee, BellySide::back, BellySide::extensor, 0.05, 0.60,
     60.0, 0.12, 0.15, 0.70, 0.0,
     "Gastrocnemius and soleus thicken by 5 to 7 mm as the foot is stretched (Maganaris, Baltzopoulos and Sargeant "
     "1998): 10 to 20 % of the calf's radius. Gastrocnemius crosses the knee too, hence the second driver."},
    {MusclePreset::triceps, left_upper_arm, left_lower_arm, elbow_straightens, BellySide::extensor, BellySide::back,
     0.15, 0.75, 70.0, 0.20, 0.18, 0.70, 45.0,
     "Extends the elbow, so that it is shortest and thickest in the straight arm. Its bellies fill the upper two "
     "thirds; "
     "below them lies the flat tendon (Gray's Anatomy). It shortens less than the biceps: its moment arm is half."},
    {MusclePreset::forearm_flexors, left_lower_arm, left_hand, wrist_or_elbow, BellySide::palm, BellySide::front, 0.05,
     0.60, 70.0, 0.10, 0.18, 0.70, 0.0,
     "Flexor carpi radialis, palmaris longus, flexor carpi ulnaris and the finger flexors: bellies in the upper half "
     "on "
     "the palm's side, tendons below (Gray's Anatomy). The wrist flexes by 70 to 80 degrees (AAOS). They arise above "
     "the "
     "elbow and help to bend it, hence the second driver, which a hand without fingers needs."},
    {MusclePreset::quadriceps, left_upper_leg, left_lower_leg, hip_or_knee, BellySide::front, BellySide::extensor, 0.25,
     0.90, 70.0, 0.10, 0.20, 0.75, 45.0,
     "Rectus femoris, the head in front, crosses the hip and shortens as the thigh is lifted. The knee, which all four "
     "heads extend, is straight in most rest poses and then leaves nothing to grow by; it is the second driver."},
    {MusclePreset::hamstrings, left_upper_leg, left_lower_leg, knee_bends, BellySide::back, BellySide::flexor, 0.20,
     0.85, 60.0, 0.11, 0.18, 0.70, 0.0,
     "Biceps femoris, semitendinosus and semimembranosus flex the knee; their bellies lie at the middle of the thigh's "
     "back, above the tendons that frame the hollow of the knee (Gray's Anatomy). 130 degrees is the usual range."},
    {MusclePreset::deltoid, left_upper_arm, left_lower_arm, arm_rises, BellySide::outer, BellySide::outer, -0.15, 0.45,
     80.0, 0.15, 0.15, 0.75, 60.0,
     "Raises the arm, in step with the elevation (Inman, Saunders and Abbott 1944); from the shoulder's rim to its "
     "tuberosity half way down the humerus. The near joint drives it: its angle is that between arm and trunk."},
    {MusclePreset::pectoral, upper_chest, left_upper_arm, arm_crosses, BellySide::front_outer, BellySide::front, 0.35,
     0.95, 60.0, 0.10, 0.20, 0.45, 45.0,
     "Pectoralis major draws the arm across the chest and down to the side (Gray's Anatomy), and is shortest with the "
     "elbow before the breastbone. The near joint of the arm drives it; the angle is to the other shoulder."},
}};

}  // namespace

std::span<const AtlasMuscle> muscle_atlas() { return atlas; }

const AtlasMuscle& atlas_muscle(MusclePreset preset) {
  const AtlasMuscle& found = atlas[static_cast<std::size_t>(preset)];
  assert(found.preset == preset);
  return found;
}

}  // namespace sinew
