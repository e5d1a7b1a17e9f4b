#pragma once
/// Small motion files.

#include <string>

#include "engine/core/files.h"

namespace sinew::test {

inline Bytes bytes_of(const std::string& text) { return Bytes(text.begin(), text.end()); }

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
