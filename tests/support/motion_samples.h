#pragma once
/// Small motion files.

#include <string>

#include <fmt/format.h>

#include "engine/core/files.h"

namespace sinew::test {

inline Bytes bytes_of(const std::string& text) { return Bytes(text.begin(), text.end()); }

/// The hierarchy of a body of 16 joints in a T pose, centimetres; six channels for the hips, then Z, X, Y turns for
/// each joint: spine, neck, head, left and right arm, forearm and hand, left and right thigh, shin and foot.
inline std::string bvh_body() {
  const std::string turns = "CHANNELS 3 Zrotation Xrotation Yrotation\n";
  std::string text = "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\n";
  text += "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n";
  text += "JOINT Spine\n{\nOFFSET 0 20 0\n" + turns + "JOINT Neck\n{\nOFFSET 0 30 0\n" + turns;
  text += "JOINT Head\n{\nOFFSET 0 10 0\n" + turns + "End Site\n{\nOFFSET 0 15 0\n}\n}\n}\n";
  const auto limb = [&](const char* format, int x) {
    for (const auto& [side, sign] : {std::pair{"Left", 1}, std::pair{"Right", -1}})
      text += fmt::format(fmt::runtime(format), side, sign * x, turns, sign * 27);
  };
  limb(
      "JOINT {0}Arm\n{{\nOFFSET {1} 25 0\n{2}JOINT {0}ForeArm\n{{\nOFFSET {3} 0 0\n{2}JOINT {0}Hand\n{{\n"
      "OFFSET {3} 0 0\n{2}End Site\n{{\nOFFSET {1} 0 0\n}}\n}}\n}}\n}}\n",
      15);
  text += "}\n";
  limb(
      "JOINT {0}UpLeg\n{{\nOFFSET {1} 0 0\n{2}JOINT {0}Leg\n{{\nOFFSET 0 -42 0\n{2}JOINT {0}Foot\n{{\n"
      "OFFSET 0 -42 0\n{2}End Site\n{{\nOFFSET 0 -5 12\n}}\n}}\n}}\n}}\n",
      9);
  return text + "}\n";
}

/// Two joints and an end; position and rotation channels in unlike orders.
inline const std::string small_bvh = R"(HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Spine
  {
    OFFSET 0 1 0
    CHANNELS 3 Yrotation Zrotation Xrotation
    End Site
    {
      OFFSET 0 2 0
    }
  }
}
MOTION
Frames: 2
Frame Time: 0.04
1 2 3 90 0 0 0 0 0
1 2 4 10 20 30 40 50 60
)";

inline const std::string small_asf = R"(# a comment
:version 1.10
:name small
:units
  mass 1.0
  length 0.5
  angle deg
:root
   order TX TY TZ RX RY RZ
   axis XYZ
   position 0 1 0
   orientation 0 0 0
:bonedata
  begin
     id 1
     name femur
     direction 0 -1 0
     length 2
     axis 0 0 90 XYZ
     dof rx ry rz
     limits (-160.0 20.0)
            (-70.0 70.0)
            (-60.0 70.0)
  end
  begin
     id 2
     name tibia
     direction 0 -1 0
     length 3
     axis 0 0 0 XYZ
     dof rx
     limits (-10.0 170.0)
  end
:hierarchy
  begin
    root femur
    femur tibia
  end
)";

inline const std::string small_amc = R"(#!OML:ASF somewhere\else.ASF
:FULLY-SPECIFIED
:DEGREES
1
root 1 2 3 0 0 0
femur 30 0 0
tibia 90
2
root 1 2 3 0 90 0
femur 0 0 0
tibia 0
)";

}  // namespace sinew::test
