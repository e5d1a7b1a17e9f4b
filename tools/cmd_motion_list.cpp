#include <iostream>

#include "engine/motion/apex.h"
#include "tools/motion_command.h"

namespace sinew::tools {
namespace {

struct ListWords : MotionWords {
  ClipQuery query;
};

Result<void> list(const ListWords& words) {
  apply_verbosity(words.common);
  if (auto ok = check_emotion(words.query.emotion); !ok) return ok;
  const auto library = open_library(words, false);
  if (!library) return tl::unexpected<Error>(library.error());
  const auto entries = library->list(words.query);
  if (!entries) return tl::unexpected<Error>(entries.error());
  nlohmann::ordered_json clips = nlohmann::ordered_json::array();
  for (const ClipEntry& entry : *entries) {
    clips.push_back(entry_json(entry));
    if (!words.common.json)
      std::cout << fmt::format("{:<32} {:>7} frames {:>8.2f} s {:>4} joints  {:<8}  {}\n", entry.name, entry.frames,
                               entry.duration(), entry.joints, entry.emotion, fmt::join(entry.tags, " "));
  }
  if (words.common.json) print_json({{"clips", clips}});
  return {};
}

struct ShowWords : MotionWords {
  std::string clip;
};

Result<void> show(const ShowWords& words) {
  apply_verbosity(words.common);
  const auto library = open_library(words, false);
  if (!library) return tl::unexpected<Error>(library.error());
  const auto clip = library->load(words.clip);
  if (!clip) return tl::unexpected<Error>(clip.error());
  nlohmann::ordered_json json = entry_json(clip->entry);
  json["fps"] = 1.0 / clip->entry.frame_time;
  json["apex"] = apex_of(*clip);
  json["apex_set"] = clip->entry.apex.has_value();
  if (!clip->entry.edit.empty()) json["edit"] = nlohmann::ordered_json::parse(clip->entry.edit, nullptr, false);
  json["skeleton"] = nlohmann::ordered_json::array();
  for (const MotionJoint& joint : clip->motion.skeleton.joints) json["skeleton"].push_back(joint.name);
  if (clip->curves) {
    json["stored_numbers"] = clip->curves->stored_numbers();
    json["sampled_numbers"] = 3 * (clip->entry.joints + 1) * clip->entry.frames;
  }
  if (words.common.json)
    print_json(json);
  else
    for (const auto& [key, value] : json.items())
      std::cout << fmt::format("{:<16} {}\n", key, value.is_string() ? value.get<std::string>() : value.dump());
  return {};
}

}  // namespace

void add_motion_list(CLI::App& motion, Run& run) {
  auto* command = motion.add_subcommand("list", "The library's clips, all or those searched for");
  command->footer("Example: sinew motion list --emotion laugh --shortest 2");
  auto words = std::make_shared<ListWords>();
  command->add_option("--name", words->query.name, "A part of the name");
  command->add_option("--tag", words->query.tag, "A tag");
  command->add_option("--emotion", words->query.emotion, "An emotion");
  command->add_option("--shortest", words->query.shortest, "Seconds that it lasts at least");
  command->add_option("--longest", words->query.longest, "Seconds that it lasts at most");
  add_motion_options(*command, *words);
  command->callback([words, &run] { run = [words] { return list(*words); }; });
}

void add_motion_show(CLI::App& motion, Run& run) {
  auto* command = motion.add_subcommand("show", "What the library knows of a clip");
  command->footer("Example: sinew motion show walk");
  auto words = std::make_shared<ShowWords>();
  command->add_option("clip", words->clip, "The clip's name")->required();
  add_motion_options(*command, *words);
  command->callback([words, &run] { run = [words] { return show(*words); }; });
}

}  // namespace sinew::tools
