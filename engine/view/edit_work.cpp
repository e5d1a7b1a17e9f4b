#include "engine/view/edit_work.h"

#include <algorithm>
#include <array>
#include <tuple>

namespace sinew {
namespace {

/// Of a character, what can take long to make. The motion's start, speed and weight cost nothing.
auto costly(const Character& character) {
  return std::tuple(character.model, character.head, character.landmarks,
                    character.motion ? std::optional(character.motion->source) : std::nullopt, character.emotion);
}

/// True where the scenes differ in their looks and muscles alone: no file is read for that, whatever became of it.
bool needs_no_parts(const Scene& a, const Scene& b) {
  if (a.fps != b.fps || a.library != b.library) return false;
  return std::ranges::equal(a.characters, b.characters, [](Character one, const Character& other) {
    one.muscles = other.muscles;
    return one == other;
  });
}

/// The characters whose costly parts differ.
std::vector<std::size_t> changed_characters(const Scene& a, const Scene& b) {
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < std::max(a.characters.size(), b.characters.size()); ++i)
    if (i >= a.characters.size() || i >= b.characters.size() || costly(a.characters[i]) != costly(b.characters[i]))
      changed.push_back(i);
  return changed;
}

/// Which kind of costly part an edit is of: edits of one kind replace each other.
auto kinds_changed(const Scene& before, const Scene& after, std::size_t character) {
  if (character >= before.characters.size() || character >= after.characters.size()) return std::array<bool, 5>{};
  const auto a = costly(before.characters[character]), b = costly(after.characters[character]);
  return std::array{std::get<0>(a) != std::get<0>(b), std::get<1>(a) != std::get<1>(b),
                    std::get<2>(a) != std::get<2>(b), std::get<3>(a) != std::get<3>(b),
                    std::get<4>(a) != std::get<4>(b)};
}

/// What an edit changed in a table of tracks, in one that others have changed since.
template <class Tracks>
void take_tracks(Tracks& to, const Tracks& from, const Tracks& wanted) {
  for (const auto& [name, track] : wanted)
    if (const auto old = from.find(name); old == from.end() || !(old->second == track)) to[name] = track;
  for (const auto& [name, track] : from)
    if (!wanted.contains(name)) to.erase(name);
}

/// What an edit changed, in a scene that others have changed since.
Scene merged(Scene now, const Scene& before, const Scene& after) {
  if (now == before || before.characters.size() != after.characters.size() ||
      now.characters.size() != before.characters.size()) {
    Scene all = after;
    all.camera = now.camera;
    return all;
  }
  const auto take = [](auto& to, const auto& from, const auto& wanted, auto... members) {
    ((from.*members == wanted.*members ? void() : void(to.*members = wanted.*members)), ...);
  };
  take(now, before, after, &Scene::fps, &Scene::frames, &Scene::look, &Scene::library);
  for (std::size_t i = 0; i < now.characters.size(); ++i) {
    take_tracks(now.characters[i].keys, before.characters[i].keys, after.characters[i].keys);
    take_tracks(now.characters[i].regions, before.characters[i].regions, after.characters[i].regions);
    take(now.characters[i], before.characters[i], after.characters[i], &Character::model, &Character::clip,
         &Character::motion, &Character::position, &Character::turn, &Character::count, &Character::muscles,
         &Character::landmarks, &Character::head, &Character::expressions, &Character::cues, &Character::emotion);
  }
  return now;
}

std::string told(const MissingParts& missing, const std::string& label) {
  const MissingParts::Part& part = missing.parts.front();
  const Character& character = missing.scene.characters[part.character];
  if (!part.needs_model) return "making ready: " + label;
  return character.head || character.model == "builtin:head" ? "drawing a head"
                                                             : "reading " + character.model.filename().string();
}

}  // namespace

bool EditWork::waits_to_step() const {
  return std::ranges::any_of(waiting_, [](const Wanted& wanted) { return wanted.kind != Kind::edit; });
}

bool EditWork::take(const Document& document, const Scene& scene, const std::string& label, const std::string& merge) {
  // A slider that comes back to what is shown takes back what it asked for.
  const bool comes_back = !waiting_.empty() && !merge.empty() && merge == waiting_.back().merge;
  const bool must_wait =
      comes_back || waits_to_step() || (is_busy() && !changed_characters(document.scene(), scene).empty());
  if (!must_wait && needs_no_parts(document.scene(), scene)) return false;
  if (!must_wait && missing_parts(document.stage(), scene, document.options()).empty()) return false;
  enqueue({Kind::edit, document.scene(), scene, label, merge});
  return true;
}

void EditWork::enqueue(Wanted wanted) {
  if (!waiting_.empty() && waiting_.back().kind == Kind::edit) {
    Wanted& last = waiting_.back();
    const bool is_made = waiting_.size() == 1 && makes_first_;
    const std::vector<std::size_t> changed = changed_characters(last.before, last.after);
    const bool same_parts = changed.size() == 1 && changed == changed_characters(wanted.before, wanted.after) &&
                            kinds_changed(last.before, last.after, changed.front()) ==
                                kinds_changed(wanted.before, wanted.after, changed.front());
    const bool replaces = wanted.merge.empty() ? same_parts : wanted.merge == last.merge;
    // What a slider passes is shown on its way; a choice that was changed is not.
    if (replaces && is_made && wanted.merge.empty()) {
      task_.cancel();
      makes_first_ = false;
    }
    if (replaces && (!is_made || wanted.merge.empty())) waiting_.pop_back();
  }
  waiting_.push_back(std::move(wanted));
}

bool EditWork::take_step(const Document& document, Kind kind) {
  const std::string label = kind == Kind::undo ? document.undo_label() : document.redo_label();
  if (!is_busy()) {
    if (label.empty()) return false;
    const Scene scene = kind == Kind::undo ? document.undo_scene() : document.redo_scene();
    if (missing_parts(document.stage(), scene, document.options()).empty()) return false;
  }
  waiting_.push_back({.kind = kind, .label = label, .merge = {}});
  return true;
}

bool EditWork::take_undo(const Document& document) { return take_step(document, Kind::undo); }

bool EditWork::take_redo(const Document& document) { return take_step(document, Kind::redo); }

std::optional<std::string> EditWork::withdraw(const Document& document) {
  if (waiting_.empty() || waiting_.back().kind != Kind::edit) return {};
  const Wanted last = waiting_.back();
  const bool partly_shown = document.is_merging() && document.merging() == last.merge;
  std::erase_if(waiting_, [&](const Wanted& wanted) { return !last.merge.empty() && wanted.merge == last.merge; });
  if (last.merge.empty()) waiting_.pop_back();
  if (waiting_.empty()) drop();
  return partly_shown ? std::nullopt : std::optional(last.label);
}

void EditWork::drop() {
  waiting_.clear();
  makes_first_ = false;
  task_.cancel();
}

void EditWork::seal(Document& document) {
  if (waiting_.empty())
    document.seal();
  else
    waiting_.back().seals = true;
}

std::optional<HeadSpec> EditWork::wanted_head(std::size_t character) const {
  for (auto wanted = waiting_.rbegin(); wanted != waiting_.rend(); ++wanted) {
    const auto &before = wanted->before.characters, &after = wanted->after.characters;
    if (character < before.size() && character < after.size() && before[character].head != after[character].head)
      return after[character].head;
  }
  return {};
}

Scene EditWork::target(const Document& document, const Wanted& wanted) {
  if (wanted.kind == Kind::edit) return merged(document.scene(), wanted.before, wanted.after);
  return wanted.kind == Kind::undo ? document.undo_scene() : document.redo_scene();
}

Result<Touched> EditWork::apply(Document& document, const Wanted& wanted) {
  if (wanted.kind == Kind::undo) return document.undo();
  if (wanted.kind == Kind::redo) return document.redo();
  auto done = document.edit(target(document, wanted), wanted.label, wanted.merge);
  if (wanted.seals) document.seal();
  return done;
}

/// Makes what the first edit needs; where that is nothing it is done at once.
std::optional<EditWork::Done> EditWork::start(Document& document) {
  if (task_.running() || waiting_.empty()) return {};
  MissingParts missing = missing_parts(document.stage(), target(document, waiting_.front()), document.options());
  if (!missing.empty()) {
    const std::string what = told(missing, waiting_.front().label);
    makes_first_ =
        task_.start(what, [missing = std::move(missing)](TaskWatch& watch) { return make_parts(missing, watch); });
    return {};
  }
  const Wanted wanted = std::move(waiting_.front());
  waiting_.pop_front();
  const std::string said = wanted.kind == Kind::edit   ? wanted.label
                           : wanted.kind == Kind::undo ? "undone: " + document.undo_label()
                                                       : "done again: " + document.redo_label();
  return Done{apply(document, wanted), said};
}

std::optional<EditWork::Done> EditWork::finish(Document& document) {
  if (auto made = task_.take()) {
    const bool is_wanted = std::exchange(makes_first_, false) && !waiting_.empty();
    if (is_wanted && *made) {
      document.lend(std::move(**made));
    } else if (is_wanted) {
      Done failed{pass_on(std::move(*made)), waiting_.front().label};
      const bool seals = waiting_.front().seals;
      waiting_.pop_front();
      if (seals) document.seal();
      return failed;
    }
  }
  return start(document);
}

}  // namespace sinew
