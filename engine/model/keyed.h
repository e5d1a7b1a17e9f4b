#pragma once
/// Values that change over the frames of a scene: keys, and what lies between them.

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/core/math.h"

namespace sinew {

/// How a value goes from one key to the next.
enum class Ease {
  linear,  ///< each number in proportion to time
  smooth,  ///< each number by 3t^2 - 2t^3: it rests at every key
  step,    ///< held until the next key
  cubic,   ///< on through the keys without a halt and never beyond them: monotone cubics (Fritsch and Butland 1984)
};

/// A value at a frame; frames may be fractions and negative.
template <class T>
struct Key {
  double frame = 0.0;
  T value{};
  bool operator==(const Key&) const = default;
};

/// The two keys around a frame and how far the value has gone from the first (0) to the second (1), ease applied.
struct KeySpan {
  std::size_t before = 0;
  std::size_t after = 0;
  double progress = 0.0;
};

inline double interpolate(double a, double b, double t) { return std::lerp(a, b, t); }

inline Vec3 interpolate(const Vec3& a, const Vec3& b, double t) {
  return {std::lerp(a.x, b.x, t), std::lerp(a.y, b.y, t), std::lerp(a.z, b.z, t)};
}

/// 0 at ends and turning points, so that the curve rests there; else the harmonic mean of the secants, weighted.
inline double cubic_slope(double before_frame, double before, double frame, double value, double after_frame,
                          double after) {
  const double h0 = frame - before_frame, h1 = after_frame - frame;
  const double d0 = (value - before) / h0, d1 = (after - value) / h1;
  if (d0 * d1 <= 0.0) return 0.0;
  const double w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

/// Between a and b with these slopes, h frames apart.
inline double hermite(double a, double slope_a, double b, double slope_b, double h, double t) {
  const double u = 1.0 - t;
  return u * u * ((1.0 + 2.0 * t) * a + t * h * slope_a) + t * t * ((1.0 + 2.0 * u) * b - u * h * slope_b);
}

/// Number by number; both of the same length.
inline std::vector<double> interpolate(std::vector<double> a, const std::vector<double>& b, double t) {
  assert(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) a[i] = std::lerp(a[i], b[i], t);
  return a;
}

inline std::size_t number_count(double) { return 1; }
inline std::size_t number_count(const Vec3&) { return 3; }
inline std::size_t number_count(const std::vector<double>& numbers) { return numbers.size(); }
inline double& number_at(double& value, std::size_t) { return value; }
inline double& number_at(Vec3& value, std::size_t i) { return value[static_cast<int>(i)]; }
inline double& number_at(std::vector<double>& value, std::size_t i) { return value[i]; }

/// A value over time: held before its first key and after its last. A value that never changes has one key.
template <class T>
struct Keyed {
  std::vector<Key<T>> keys;  ///< frames strictly rising; never empty where a value is asked for
  Ease ease = Ease::linear;  ///< between all keys alike

  static Keyed constant(T value) { return {{{0.0, std::move(value)}}, Ease::linear}; }
  bool is_constant() const { return keys.size() == 1; }

  /// Which keys make the value at `frame`; before == after where one key alone does.
  KeySpan span_at(double frame) const {
    assert(!keys.empty());
    const auto next = std::upper_bound(keys.begin(), keys.end(), frame,
                                       [](double wanted, const Key<T>& key) { return wanted < key.frame; });
    if (next == keys.begin()) return {0, 0, 0.0};
    const auto after = static_cast<std::size_t>(next - keys.begin());
    if (next == keys.end() || ease == Ease::step) return {after - 1, after - 1, 0.0};
    const double before_frame = keys[after - 1].frame;
    const double t = (frame - before_frame) / (next->frame - before_frame);
    return {after - 1, after, ease == Ease::smooth ? smoothstep01(t) : t};
  }

  /// The value at any frame, for T that interpolate() knows.
  T value_at(double frame) const {
    const KeySpan span = span_at(frame);
    if (span.before == span.after) return keys[span.before].value;
    if (ease == Ease::cubic) return cubic_at(span);
    return interpolate(keys[span.before].value, keys[span.after].value, span.progress);
  }

  bool operator==(const Keyed&) const = default;

 private:
  T cubic_at(const KeySpan& span) const {
    T out = keys[span.before].value;
    const double h = keys[span.after].frame - keys[span.before].frame;
    for (std::size_t i = 0; i < number_count(out); ++i) {
      const auto number = [&](std::size_t key) {
        T value = keys[key].value;
        return number_at(value, i);
      };
      const auto slope = [&](std::size_t k) {
        if (k == 0 || k + 1 == keys.size()) return 0.0;
        return cubic_slope(keys[k - 1].frame, number(k - 1), keys[k].frame, number(k), keys[k + 1].frame,
                           number(k + 1));
      };
      number_at(out, i) =
          hermite(number(span.before), slope(span.before), number(span.after), slope(span.after), h, span.progress);
    }
    return out;
  }
};

}  // namespace sinew
