#include "engine/view/head_work.h"

#include <chrono>

namespace sinew {

bool HeadWork::take(const Document& document, const Scene& scene, const std::string& label, const std::string& merge) {
  const Scene& now = document.scene();
  for (std::size_t i = 0; i < std::min(scene.characters.size(), now.characters.size()); ++i) {
    const Character& character = scene.characters[i];
    // A slider that comes back to the head that is shown takes back what it asked for.
    const bool comes_back = is_busy() && drawn_ && drawn_->character == i && merge == merge_;
    if (!character.head || (character.head == now.characters[i].head && !comes_back)) continue;
    // While a head is drawn later ones wait their turn, spare or not.
    if (!is_busy() && !needs_model(document.stage(), character)) continue;
    wanted_ = Wanted{i, *character.head};
    label_ = label;
    merge_ = merge;
    seals_ = false;
    if (!is_busy()) start(document);
    return true;
  }
  return false;
}

void HeadWork::start(const Document& document) {
  drawn_ = wanted_;
  Scene scene = document.scene();
  scene.characters[drawn_->character].head = drawn_->head;
  drawing_ = std::async(std::launch::async, [scene = std::move(scene), character = drawn_->character,
                                             options = document.options(), source = document.stage().source] {
    return ready_character(scene, character, options, source);
  });
}

std::optional<Result<Touched>> HeadWork::finish(Document& document) {
  if (!drawing_.valid() || drawing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
  auto ready = drawing_.get();
  if (!drawn_) {
    // It was dropped while it was drawn; another one may have been asked for since.
    if (wanted_) start(document);
    return {};
  }
  if (!ready) {
    wanted_.reset();
    return pass_on(std::move(ready));
  }
  document.lend(std::move(*ready));
  Scene scene = document.scene();
  scene.characters[drawn_->character].head = drawn_->head;
  auto done = document.edit(std::move(scene), label_, merge_);
  if (!done || wanted_ == drawn_)
    wanted_.reset();
  else
    start(document);
  if (!is_busy() && seals_) document.seal();
  return done;
}

}  // namespace sinew
