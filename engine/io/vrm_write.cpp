#include "engine/io/vrm_write.h"

#include <algorithm>
#include <set>

#include "engine/core/text.h"
#include "engine/io/gltf_write_parts.h"

namespace sinew {
namespace {

enum class MetaKind { text, list, flag, word };

struct MetaKey {
  std::string name;
  MetaKind kind;
  std::vector<std::string> words{};  ///< of MetaKind::word
};

/// VRMC_vrm 1.0, meta; pictures are left out.
const std::vector<MetaKey>& meta_keys() {
  static const std::vector<MetaKey> keys{
      {"name", MetaKind::text},
      {"version", MetaKind::text},
      {"authors", MetaKind::list},
      {"copyrightInformation", MetaKind::text},
      {"contactInformation", MetaKind::text},
      {"references", MetaKind::list},
      {"thirdPartyLicenses", MetaKind::text},
      {"licenseUrl", MetaKind::text},
      {"avatarPermission", MetaKind::word, {"onlyAuthor", "onlySeparatelyLicensedPerson", "everyone"}},
      {"allowExcessivelyViolentUsage", MetaKind::flag},
      {"allowExcessivelySexualUsage", MetaKind::flag},
      {"commercialUsage", MetaKind::word, {"personalNonProfit", "personalProfit", "corporation"}},
      {"allowPoliticalOrReligiousUsage", MetaKind::flag},
      {"allowAntisocialOrHateUsage", MetaKind::flag},
      {"creditNotation", MetaKind::word, {"required", "unnecessary"}},
      {"allowRedistribution", MetaKind::flag},
      {"modification", MetaKind::word, {"prohibited", "allowModification", "allowModificationRedistribution"}},
      {"otherLicenseUrl", MetaKind::text},
  };
  return keys;
}

const MetaKey* find_key(const std::string& name) {
  const auto found = std::ranges::find(meta_keys(), name, &MetaKey::name);
  return found == meta_keys().end() ? nullptr : &*found;
}

Json written_meta(const VrmMeta& meta) {
  VrmMeta all = meta;
  all.values.try_emplace("name", std::vector<std::string>{"figure"});
  all.values.try_emplace("authors", std::vector<std::string>{"unknown"});
  all.values.try_emplace("licenseUrl", std::vector<std::string>{"https://vrm.dev/licenses/1.0/"});
  Json out = Json::object();
  for (const MetaKey& key : meta_keys()) {
    const auto found = all.values.find(key.name);
    if (found == all.values.end()) continue;
    if (key.kind == MetaKind::list)
      out[key.name] = found->second;
    else if (key.kind == MetaKind::flag)
      out[key.name] = found->second.back() == "true";
    else
      out[key.name] = found->second.back();
  }
  return out;
}

/// The presets of VRM 1.0; expressions of other names are custom.
bool is_vrm_preset(const std::string& name) {
  static const std::set<std::string> presets{"happy",      "angry",  "sad",      "relaxed",  "surprised", "aa",
                                             "ih",         "ou",     "ee",       "oh",       "blink",     "blinkLeft",
                                             "blinkRight", "lookUp", "lookDown", "lookLeft", "lookRight", "neutral"};
  return presets.contains(name);
}

/// Every morph target of that name, at the node that draws it.
Json written_binds(const Model& model, const RigLayout& layout, const std::string& name) {
  Json binds = Json::array();
  for (std::size_t node = 0; node < model.nodes.size(); ++node) {
    if (layout.drawing_node[node] < 0 || model.meshes[model.nodes[node].mesh].primitives.empty()) continue;
    const auto& targets = model.meshes[model.nodes[node].mesh].primitives.front().morph_targets;
    const auto found = std::ranges::find(targets, name, &MorphTarget::name);
    if (found != targets.end())
      binds.push_back({{"node", layout.drawing_node[node]}, {"index", found - targets.begin()}, {"weight", 1.0}});
  }
  return binds;
}

Json written_expressions(const Model& model, std::span<const VrmExpression> expressions) {
  const RigLayout layout = rig_layout(model);
  Json out = Json::object();
  for (const VrmExpression& expression : expressions) {
    Json binds = written_binds(model, layout, expression.name);
    if (binds.empty()) continue;
    out[is_vrm_preset(expression.name) ? "preset" : "custom"][expression.name] = {
        {"morphTargetBinds", std::move(binds)},
        {"isBinary", false},
        {"overrideMouth", expression.mouth},
        {"overrideBlink", expression.blink},
        {"overrideLookAt", expression.look}};
  }
  return out;
}

}  // namespace

Result<void> add_vrm_meta(VrmMeta& meta, std::string_view word) {
  const std::size_t equals = word.find('=');
  if (equals == std::string_view::npos || equals == 0 || equals + 1 == word.size())
    return failure(ErrorKind::usage, "--meta {}: expected KEY=VALUE, such as name=Figure", word);
  const std::string name(word.substr(0, equals)), value(word.substr(equals + 1));
  const MetaKey* key = find_key(name);
  if (key == nullptr) {
    std::vector<std::string> known;
    for (const MetaKey& k : meta_keys()) known.push_back(k.name);
    return failure(ErrorKind::usage, "--meta {}: VRM has no key \"{}\"{}; there are {}", word, name,
                   did_you_mean(name, known), fmt::join(known, ", "));
  }
  const std::vector<std::string> words =
      key->kind == MetaKind::flag ? std::vector<std::string>{"true", "false"} : key->words;
  if (!words.empty() && std::ranges::find(words, value) == words.end())
    return failure(ErrorKind::usage, "--meta {}: expected one of {}", word, fmt::join(words, ", "));
  std::vector<std::string>& values = meta.values[name];
  if (key->kind != MetaKind::list) values.clear();
  values.push_back(value);
  return {};
}

Result<Bytes> vrm_glb(const Model& model, const std::map<std::string, int>& bones, const VrmMeta& meta,
                      std::span<const VrmExpression> expressions) {
  GlbBuilder glb;
  write_rig(model, glb);
  Json human_bones = Json::object();
  for (const auto& [bone, node] : bones) human_bones[bone] = {{"node", node}};
  glb.json["extensionsUsed"] = Json::array({"VRMC_vrm"});
  glb.json["extensions"]["VRMC_vrm"] = {
      {"specVersion", "1.0"}, {"meta", written_meta(meta)}, {"humanoid", {{"humanBones", human_bones}}}};
  Json written = written_expressions(model, expressions);
  if (!written.empty()) glb.json["extensions"]["VRMC_vrm"]["expressions"] = std::move(written);
  return glb.finish();
}

}  // namespace sinew
