#include <algorithm>

#include <spdlog/spdlog.h>

#include "engine/core/files.h"
#include "engine/io/json_parser.h"
#include "engine/motion/apex.h"
#include "engine/motion/library_edit.h"
#include "tools/motion_command.h"
#include "tools/motion_edit_words.h"

namespace sinew::tools {
namespace {

struct Words : MotionWords {
  const CLI::App* command = nullptr;
  std::string clip, as;
  std::deque<EditOption> edits;
  std::optional<std::string> edits_file, replay, emotion, source, licence;
  std::optional<double> apex;
  std::vector<std::string> tags, untag;
  bool replace = false;

  bool annotates() const { return emotion || source || licence || apex || !tags.empty() || !untag.empty(); }
};

Result<nlohmann::json> all_edits(const Words& words, const MotionLibrary& library) {
  auto edits = typed_edits(*words.command, words.edits);
  if (!edits) return edits;
  nlohmann::json all = nlohmann::json::array();
  if (words.replay) {
    auto replayed = edits_of(library, *words.replay);
    if (!replayed) return replayed;
    all = std::move(*replayed);
  }
  if (words.edits_file) {
    const auto bytes = read_file(*words.edits_file, std::size_t{16} << 20);
    if (!bytes) return tl::unexpected<Error>(bytes.error());
    const auto list = parse_json({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, *words.edits_file);
    if (!list) return tl::unexpected<Error>(list.error());
    if (!list->is_array()) return bad_input("{}: expected a list of edits", *words.edits_file);
    all.insert(all.end(), list->begin(), list->end());
  }
  all.insert(all.end(), edits->begin(), edits->end());
  return all;
}

Result<void> annotate(const Words& words, MotionLibrary& library, const std::string& name) {
  const auto clip = library.load(name);
  if (!clip) return tl::unexpected<Error>(clip.error());
  ClipEntry entry = clip->entry;
  if (words.emotion) entry.emotion = *words.emotion;
  if (words.source) entry.source = *words.source;
  if (words.licence) entry.licence = *words.licence;
  if (words.apex) {
    if (!(*words.apex >= 0.0 && *words.apex <= entry.duration()))
      return bad_input("--apex {}: clip \"{}\" lasts from 0 to {} s", *words.apex, name, entry.duration());
    entry.apex = words.apex;
  }
  entry.tags.insert(entry.tags.end(), words.tags.begin(), words.tags.end());
  for (const std::string& tag : words.untag) std::erase(entry.tags, tag);
  if (auto ok = library.begin(); !ok) return ok;
  if (auto ok = library.annotate(entry); !ok) return ok;
  return library.commit();
}

Result<void> edit(const Words& words) {
  apply_verbosity(words.common);
  if (auto ok = check_emotion(words.emotion.value_or("")); !ok) return ok;
  if (auto ok = check_tags(words.tags); !ok) return ok;
  const auto typed = typed_edits(*words.command, words.edits);
  if (!typed) return tl::unexpected<Error>(typed.error());
  const bool edits = !typed->empty() || words.edits_file || words.replay;
  if (!edits && !words.annotates())
    return failure(ErrorKind::usage, "nothing to do; name an edit such as --scale neck=1.5, or a tag");
  if (edits == words.as.empty())
    return failure(ErrorKind::usage, "{}",
                   edits ? "an edit makes a new clip; name it with --as"
                         : "--as names the clip that an edit makes, and there is no edit");
  auto library = open_library(words, true);
  if (!library) return pass_on(std::move(library));
  std::string changed = words.clip;
  if (edits) {
    const auto all = all_edits(words, *library);
    if (!all) return tl::unexpected<Error>(all.error());
    const auto made = edit_clip(*library, words.clip, words.as, *all, words.replace);
    if (!made) return tl::unexpected<Error>(made.error());
    changed = words.as;
  }
  if (words.annotates())
    if (auto ok = annotate(words, *library, changed); !ok) return ok;
  const auto entry = library->load(changed);
  if (!entry) return tl::unexpected<Error>(entry.error());
  spdlog::info("clip \"{}\": {} frames, {:.2f} s", changed, entry->entry.frames, entry->entry.duration());
  if (words.common.json) {
    nlohmann::ordered_json json = entry_json(entry->entry);
    json["apex"] = apex_of(*entry);
    if (!entry->entry.edit.empty()) json["edit"] = nlohmann::ordered_json::parse(entry->entry.edit, nullptr, false);
    print_json(json);
  }
  return {};
}

}  // namespace

void add_motion_edit(CLI::App& motion, Run& run) {
  auto* command = motion.add_subcommand("edit", "Makes a new clip from one by edits, or tags one");
  command->footer(
      "Example: sinew motion edit walk --as swagger --scale leftUpperArm=1.5 --warp 1.2\n"
      "         sinew motion edit walk --tag calm --emotion neutral");
  auto words = std::make_shared<Words>();
  words->command = command;
  command->add_option("clip", words->clip, "The clip's name")->required();
  command->add_option("--as", words->as, "The new clip's name");
  add_edit_options(*command, words->edits);
  command->add_option("--edits", words->edits_file, "A JSON file with a list of edits");
  command->add_option("--replay", words->replay, "All edits that made this clip, on CLIP");
  command->add_flag("--replace", words->replace, "Take the place of a clip of the new name");
  command->add_option("--tag", words->tags, "Add a tag; repeatable")->allow_extra_args(false);
  command->add_option("--untag", words->untag, "Take a tag away; repeatable")->allow_extra_args(false);
  command->add_option("--emotion", words->emotion, "The emotion that it shows");
  command->add_option("--apex", words->apex, "Seconds at which it is strongest");
  command->add_option("--source", words->source, "Where it comes from");
  command->add_option("--licence", words->licence, "Its terms");
  add_motion_options(*command, *words);
  command->callback([words, &run] { run = [words] { return edit(*words); }; });
}

}  // namespace sinew::tools
