#include "engine/face/landmarks.h"

#include <algorithm>

#include "engine/core/files.h"
#include "engine/face/head_cage_parts.h"
#include "engine/io/json_reader.h"

namespace sinew {
namespace {

constexpr int margin = 2, contact = 2, border = 4;  // rings of the lids' edge, of the lips' meeting and their border

std::vector<LandmarkName> all_names() {
  std::vector<LandmarkName> out;
  const auto middle = [&](const char* name, const CagePoint& place, bool required = false) {
    out.push_back({name, place, false, required});
  };
  const auto sides = [&](const std::string& name, const CagePoint& place, bool required = false) {
    out.push_back({name + "Left", place, false, required});
    out.push_back({name + "Right", place, true, required});
  };
  middle("hairLine", forehead_point(2, 0));
  middle("brow", nose_point(0, 0));
  middle("eyeLine", nose_point(0, 2));
  middle("noseTip", nose_point(0, 5), true);
  middle("noseBase", mouth_point(6, 0), true);
  middle("lipTop", mouth_point(border, 0));
  middle("upperLip", mouth_point(contact, 0));
  middle("lipContact", mouth_point(contact, 0));
  middle("lowerLip", mouth_point(contact, 10));
  middle("lipBottom", mouth_point(border, 10));
  middle("chin", chin_point(3, 2), true);
  sides("browInner", eye_point(6, 2));
  sides("browMiddle", eye_point(6, 4));
  sides("browOuter", eye_point(6, 6));
  sides("eyeInner", eye_point(margin, 0), true);
  sides("eyeOuter", eye_point(margin, 8), true);
  sides("lidUpperInner", eye_point(margin, 3));
  sides("lidUpper", eye_point(margin, 4));
  sides("lidUpperOuter", eye_point(margin, 5));
  sides("lidLowerInner", eye_point(margin, 13));
  sides("lidLower", eye_point(margin, 12));
  sides("lidLowerOuter", eye_point(margin, 11));
  sides("noseWing", nose_point(2, 7));
  sides("lipCorner", mouth_point(contact, 5), true);
  sides("lipPeak", mouth_point(border, 1));
  sides("lipTopSide", mouth_point(border, 3));
  sides("lipBottomSide", mouth_point(border, 7));
  sides("upperLipSide", mouth_point(contact, 2));
  sides("lowerLipSide", mouth_point(contact, 8));
  sides("jawCorner", side_point(1, 16));
  sides("earTop", ear_point(2, 17));
  sides("earBottom", ear_point(2, 8));
  return out;
}

}  // namespace

std::span<const LandmarkName> landmark_names() {
  static const std::vector<LandmarkName> all = all_names();
  return all;
}

Result<void> check_landmarks(const LandmarkPlaces& places, const std::string& name) {
  const bool lips = places.contains("upperLip") && places.contains("lowerLip");
  for (const LandmarkName& l : landmark_names())
    if (l.required && !places.contains(l.name))
      return bad_input("{}: /landmarks: no \"{}\", expected its vertex number or place [x, y, z]", name, l.name);
  if (!lips && !places.contains("lipContact"))
    return bad_input("{}: /landmarks: no \"lipContact\", expected it, or both \"upperLip\" and \"lowerLip\"", name);
  return {};
}

Result<LandmarkPlaces> parse_landmarks(std::string_view text, const std::string& name) {
  const auto json = parse_json(text, name);
  if (!json) return tl::unexpected<Error>(json.error());
  JsonReport report(name);
  const JsonValue root(*json, report);
  static const std::vector<std::string> keys{"landmarks"};
  LandmarkPlaces out;
  root.expect_object(keys);
  if (const auto all = root.require("landmarks", "an object: landmark to vertex number or [x, y, z]")) {
    std::vector<std::string> known;
    for (const LandmarkName& l : landmark_names()) known.push_back(l.name);
    all->expect_object(known);
    for (const LandmarkName& l : landmark_names()) {
      const auto value = all->find(l.name);
      if (!value) continue;
      if (value->is_list())
        out[l.name] = value->vec3("three numbers [x, y, z], or a vertex number");
      else if (value->is_number())
        out[l.name] = static_cast<std::uint32_t>(value->integer(0, std::numeric_limits<int>::max()));
      else
        value->error_expected("a vertex number, or three numbers [x, y, z]");
    }
  }
  if (report.error()) return tl::unexpected<Error>(*report.error());
  if (auto ok = check_landmarks(out, name); !ok) return pass_on(std::move(ok));
  return out;
}

Result<LandmarkPlaces> read_landmarks(const std::filesystem::path& file) {
  const auto bytes = read_file(file);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  return parse_landmarks(std::string(bytes->begin(), bytes->end()), file.string());
}

std::string landmarks_text(const LandmarkPlaces& places) {
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  for (const LandmarkName& l : landmark_names()) {
    const auto found = places.find(l.name);
    if (found == places.end()) continue;
    if (const auto* vertex = std::get_if<std::uint32_t>(&found->second)) {
      all[l.name] = *vertex;
    } else {
      const Vec3& p = std::get<Vec3>(found->second);
      all[l.name] = {p.x, p.y, p.z};
    }
  }
  return nlohmann::ordered_json{{"landmarks", all}}.dump(1) + "\n";
}

}  // namespace sinew
