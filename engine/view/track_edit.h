#pragma once
/// How a value over time is edited at the frame that is shown. What never changes is one value for all frames until a
/// key is asked for.

#include <algorithm>
#include <cmath>

#include "engine/model/keyed.h"

namespace sinew {

template <class T>
auto key_at(Keyed<T>& track, double frame) {
  return std::ranges::find(track.keys, frame, &Key<T>::frame);
}

/// Makes a value a key at this frame, in place of one that is there.
template <class T>
void put_key(Keyed<T>& track, double frame, T value) {
  if (const auto key = key_at(track, frame); key != track.keys.end()) {
    key->value = std::move(value);
    return;
  }
  const auto next = std::ranges::lower_bound(track.keys, frame, {}, &Key<T>::frame);
  track.keys.insert(next, {frame, std::move(value)});
}

/// Changes the one value of what rests, else puts a key.
template <class T>
void set_value(Keyed<T>& track, double frame, T value) {
  if (track.is_constant())
    track.keys.front().value = std::move(value);
  else
    put_key(track, frame, std::move(value));
}

/// Moves a key to another frame, held a frame away from its neighbours; where there is no room it stays.
template <class T>
void move_key(Keyed<T>& track, std::size_t key, double frame) {
  const double low = key > 0 ? track.keys[key - 1].frame + 1.0 : -INFINITY;
  const double high = key + 1 < track.keys.size() ? track.keys[key + 1].frame - 1.0 : INFINITY;
  if (low <= high) track.keys[key].frame = std::clamp(frame, low, high);
}

/// Takes the key at a frame away; true where that was the last one.
template <class T>
bool remove_key(Keyed<T>& track, double frame) {
  if (const auto key = key_at(track, frame); key != track.keys.end()) track.keys.erase(key);
  return track.keys.empty();
}

}  // namespace sinew
