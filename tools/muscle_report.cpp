#include "tools/muscle_report.h"

#include <algorithm>

namespace sinew::tools {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Vec3& v) { return {v.x, v.y, v.z}; }

Json muscle_json(const Model& model, const PlacedMuscle& placed) {
  const Muscle& m = placed.muscle;
  Json except = Json::array();
  for (const int node : m.except) except.push_back(node_name(model, node));
  return {{"name", m.name},
          {"bone", node_name(model, m.bone)},
          {"child", node_name(model, m.child)},
          {"driver", node_name(model, m.driver)},
          {"before", node_name(model, m.before)},
          {"tip", node_name(model, m.tip)},
          {"except", except},
          {"facing", vector_json(placed.region.plane.normal)},
          {"from", m.from},
          {"to", m.to},
          {"spread", m.spread},
          {"peak", m.peak},
          {"sigma", {m.sigma.x, m.sigma.y}},
          {"rest_angle", m.rest_angle},
          {"reference_angle", m.reference_angle},
          {"on", m.on},
          {"centre", vector_json(placed.region.centre)},
          {"region_vertices", placed.region.vertices.size()},
          {"segment_vertices", placed.region.segment_vertices}};
}

/// Terminals count columns, not bytes: a character of several bytes is one column.
std::size_t columns(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string numbers(const Json& list, const char* separator) {
  std::string text;
  for (const Json& number : list) text += fmt::format("{}{:.3g}", text.empty() ? "" : separator, number.get<double>());
  return text;
}

using Row = std::vector<std::string>;

Row row_of(const Json& muscle) {
  const auto text = [&](const char* key) { return muscle[key].get<std::string>(); };
  Row row{text("name") + (muscle["on"].get<bool>() ? "" : " (off)"),
          fmt::format("{} to {}", text("bone"), text("child")),
          text("driver"),
          numbers(muscle["facing"], ","),
          fmt::format("{:.2f}-{:.2f}", muscle["from"].get<double>(), muscle["to"].get<double>()),
          fmt::format("{:.0f}", muscle["spread"].get<double>()),
          fmt::format("{:.4g}", muscle["peak"].get<double>()),
          numbers(muscle["sigma"], ","),
          fmt::format("{:.1f} to {:.1f}", muscle["rest_angle"].get<double>(), muscle["reference_angle"].get<double>()),
          fmt::format("{} of {}", muscle["region_vertices"].get<std::size_t>(),
                      muscle["segment_vertices"].get<std::size_t>())};
  if (muscle.contains("angle")) {
    row.push_back(fmt::format("{:.1f}", muscle["angle"].get<double>()));
    row.push_back(fmt::format("{:.3f}", muscle["activation"].get<double>()));
  }
  return row;
}

}  // namespace

std::string node_name(const Model& model, int node) {
  const std::string& name = model.nodes[node].name;
  return name.empty() ? fmt::format("nodes/{}", node) : name;
}

Json muscles_json(const Stage& stage, bool posed) {
  Json muscles = Json::array();
  for (std::size_t i = 0; i < stage.characters.size(); ++i) {
    const StagedCharacter& character = stage.characters[i];
    const CharacterState state = character_state(stage, i, stage.range.first);
    for (std::size_t m = 0; m < character.muscles.size(); ++m) {
      Json json = muscle_json(*character.model, character.muscles[m]);
      if (posed) {
        json["angle"] = character.muscles[m].driver.degrees(state.global);
        json["activation"] = state.activations[m];
      }
      muscles.push_back(std::move(json));
    }
  }
  return muscles;
}

std::string muscle_table(const Json& muscles) {
  if (muscles.empty()) return "";
  std::vector<Row> rows{{"muscle", "segment", "driver", "facing", "region", "spread", "peak", "sigma",
                         "angle, rest to peak", "vertices"}};
  if (muscles.front().contains("angle")) rows.front().insert(rows.front().end(), {"angle now", "activation"});
  for (const Json& muscle : muscles) rows.push_back(row_of(muscle));
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], columns(row[i]));
  std::string table;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line += row[i] + std::string(i + 1 < row.size() ? widths[i] - columns(row[i]) + 2 : 0, ' ');
    table += "  " + line + "\n";
  }
  return table;
}

}  // namespace sinew::tools
