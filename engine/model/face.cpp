#include "engine/model/face.h"

namespace sinew {

const std::array<FaceChannelName, face_channels>& face_channel_names() {
  static constexpr std::array<FaceChannelName, face_channels> names = {
      {{"browLeft", "right"},    {"browLeft", "up"},      {"browLeft", "turn"},
       {"browRight", "right"},   {"browRight", "up"},     {"browRight", "turn"},
       {"upperLidLeft", ""},     {"upperLidRight", ""},   {"lowerLidLeft", ""},
       {"lowerLidRight", ""},    {"eyeLeft", "yaw"},      {"eyeLeft", "pitch"},
       {"eyeRight", "yaw"},      {"eyeRight", "pitch"},   {"upperLip", ""},
       {"lowerLip", ""},         {"cornerLeft", "right"}, {"cornerLeft", "up"},
       {"cornerRight", "right"}, {"cornerRight", "up"},   {"jaw", ""},
       {"cheekLeft", ""},        {"cheekRight", ""},      {"nose", ""},
       {"lipPucker", ""},        {"lipPress", ""},        {"lipSeal", ""}}};
  return names;
}

}  // namespace sinew
