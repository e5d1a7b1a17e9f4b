#include "engine/app/emotion_use.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/core/text.h"
#include "engine/model/scene_words.h"
#include "engine/motion/apex.h"

namespace sinew {
namespace {

constexpr double blend_seconds = 0.3;

std::string name_of(Expression emotion) { return std::string(expression_names()[static_cast<std::size_t>(emotion)]); }

/// Keeps the keys' frames strictly rising: of two at one frame the earlier stays.
void add_key(std::vector<Key<ExpressionWeight>>& keys, double frame, ExpressionWeight weight) {
  const auto at = std::lower_bound(keys.begin(), keys.end(), frame,
                                   [](const Key<ExpressionWeight>& key, double f) { return key.frame < f; });
  if (at == keys.end() || at->frame != frame) keys.insert(at, {frame, weight});
}

}  // namespace

Result<StoredClip> clip_of_emotion(const MotionLibrary& library, Expression emotion) {
  const std::string name = name_of(emotion);
  const auto clips = library.list();
  if (!clips) return tl::unexpected<Error>(clips.error());
  const auto named = [&](const ClipEntry& clip) { return clip.emotion == name; };
  const auto tagged = [&](const ClipEntry& clip) {
    return std::find(clip.tags.begin(), clip.tags.end(), name) != clip.tags.end();
  };
  auto found = std::find_if(clips->begin(), clips->end(), named);
  if (found == clips->end()) found = std::find_if(clips->begin(), clips->end(), tagged);
  if (found != clips->end()) return library.load(found->name);
  std::set<std::string> known;
  for (const ClipEntry& clip : *clips)
    if (!clip.emotion.empty()) known.insert(clip.emotion);
  return bad_input("{}: no clip shows \"{}\"; {}. `sinew motion edit CLIP --emotion {}` marks one",
                   library.file().string(), name,
                   known.empty() ? fmt::format("none of its {} clips has an emotion", clips->size())
                                 : fmt::format("there are clips for {}", fmt::join(known, ", ")),
                   name);
}

MotionUse use_for_cue(const EmotionCue& cue, const ClipEntry& clip, double apex, double fps) {
  const double begin = cue.frame - apex * fps, end = begin + clip.duration() * fps, blend = blend_seconds * fps;
  const double risen = std::min(begin + blend, cue.frame), falling = std::max(end - blend, cue.frame);
  MotionUse use;
  use.source = LibraryClip{clip.name};
  use.start = begin;
  use.weight = {{{risen - blend, 0.0}, {risen, cue.strength}}, Ease::smooth};
  if (falling > risen) use.weight.keys.push_back({falling, cue.strength});
  use.weight.keys.push_back({falling + blend, 0.0});
  return use;
}

EmotionSpan span_of(const Motion& motion, const MotionUse& use, double apex, double fps) {
  const std::vector<double> all = deviations(motion);
  const auto at_apex = static_cast<std::size_t>(
      std::clamp(std::llround(apex / motion.frame_time), 0LL, static_cast<long long>(all.size()) - 1));
  const auto is_near = [&](double deviation) { return deviation >= near_apex * all[at_apex]; };
  const auto frame = [&](std::ptrdiff_t index) {
    return use.start + static_cast<double>(index) * motion.frame_time * fps;
  };
  // The apex itself is near, so that both are found.
  const auto first = std::find_if(all.begin(), all.end(), is_near);
  const auto last = std::find_if(all.rbegin(), all.rend(), is_near);
  return {use.weight.keys.front().frame, frame(first - all.begin()), frame(all.rend() - last - 1),
          use.weight.keys.back().frame};
}

std::optional<Keyed<ExpressionWeight>> expressions_with(const std::optional<Keyed<ExpressionWeight>>& own,
                                                        std::span<const EmotionCue> cues,
                                                        std::span<const EmotionSpan> spans) {
  if (cues.empty()) return own;
  Keyed<ExpressionWeight> all;
  if (own) all = *own;
  for (const EmotionCue& cue : cues) add_key(all.keys, cue.frame, {cue.emotion, cue.strength});
  const std::vector<Key<ExpressionWeight>> asked = all.keys;
  const auto none_between = [&](double first, double last) {
    return std::none_of(asked.begin(), asked.end(),
                        [&](const Key<ExpressionWeight>& key) { return key.frame > first && key.frame < last; });
  };
  for (std::size_t i = 0; i < cues.size(); ++i) {
    const EmotionSpan& span = spans[i];
    const double apex = cues[i].frame;
    const ExpressionWeight near{cues[i].emotion, near_apex * cues[i].strength}, neutral{Expression::neutral, 1.0};
    if (none_between(span.begin, apex)) {
      add_key(all.keys, span.begin, neutral);
      if (span.near > span.begin && span.near < apex) add_key(all.keys, span.near, near);
    }
    if (none_between(apex, span.end)) {
      add_key(all.keys, span.end, neutral);
      if (span.leaving > apex && span.leaving < span.end) add_key(all.keys, span.leaving, near);
    }
  }
  return all;
}

Result<StagedMotion> stage_emotion(const EmotionCue& cue, const MotionLibrary& library, double fps, const Model& model,
                                   const Humanoid& humanoid) {
  auto clip = clip_of_emotion(library, cue.emotion);
  if (!clip) return pass_on(std::move(clip));
  const double apex = apex_of(*clip);
  const MotionUse use = use_for_cue(cue, clip->entry, apex, fps);
  const std::string name = fmt::format("clip {}", clip->entry.name);
  const Motion motion = played_motion(std::move(*clip));
  auto staged = put_motion(motion, name, use, model, humanoid);
  if (!staged) return pass_on(std::move(staged));
  staged->file = library.file().string();
  staged->span = span_of(motion, use, apex, fps);
  return staged;
}

}  // namespace sinew
