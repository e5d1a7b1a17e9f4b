#include "engine/render/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "engine/core/math.h"
#include "engine/core/parallel.h"

namespace sinew {
namespace {

using std::numbers::pi;

/// One number a pixel, rows from the top.
struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;

  Plane(int width, int height) : width(width), height(height), values(std::size_t(width) * height) {}
  const float* row(int y) const { return values.data() + std::size_t(y) * width; }
  float* row(int y) { return values.data() + std::size_t(y) * width; }
};

using Planes = std::array<Plane, 3>;

/// Weights of 2 * reach + 1 neighbours.
struct Kernel {
  int reach = 0;
  std::vector<double> weights;

  template <class Weight>
  Kernel(int reach, const Weight& weight) : reach(reach) {
    for (int i = -reach; i <= reach; ++i) weights.push_back(weight(i));
  }
  double sum() const { return std::accumulate(weights.begin(), weights.end(), 0.0); }
  Kernel divided(double by) const {
    Kernel kernel = *this;
    for (double& weight : kernel.weights) weight /= by;
    return kernel;
  }
};

// ---- Colours ----

/// IEC 61966-2-1.
double linear_from_srgb(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

/// Linear Rec. 709 red, green, blue to XYZ, columns; white is D65's (1, 1, 1).
const Mat3& xyz_from_rgb() {
  static const Mat3 matrix{{0.4123907992659595, 0.21263900587151036, 0.01933081871559185},
                           {0.35758433938387796, 0.7151686787677559, 0.11919477979462599},
                           {0.1804807884018343, 0.07219231536073371, 0.9505321522496606}};
  return matrix;
}

const Mat3& rgb_from_xyz() {
  static const Mat3 matrix = glm::inverse(xyz_from_rgb());
  return matrix;
}

/// XYZ of white.
const Vec3& white() {
  static const Vec3 xyz = xyz_from_rgb() * Vec3(1.0);
  return xyz;
}

/// A linear opponent space: brightness, red against green, yellow against blue.
Vec3 ycxcz_from_rgb(const Vec3& rgb) {
  const Vec3 share = xyz_from_rgb() * rgb / white();
  return {116.0 * share.y - 16.0, 500.0 * (share.x - share.y), 200.0 * (share.y - share.z)};
}

Vec3 rgb_from_ycxcz(const Vec3& c) {
  const double y = (c.x + 16.0) / 116.0;
  return rgb_from_xyz() * (Vec3(y + c.y / 500.0, y, y - c.z / 200.0) * white());
}

/// CIELAB's cube root with its straight foot.
double lab_curve(double share) {
  constexpr double foot = 6.0 / 29.0;
  return share > foot * foot * foot ? std::cbrt(share) : share / (3.0 * foot * foot) + 4.0 / 29.0;
}

/// CIELAB, its colour scaled by lightness: what is dark looks less colourful (Hunt).
Vec3 hunt_lab(const Vec3& rgb) {
  const Vec3 share = xyz_from_rgb() * rgb / white();
  const double x = lab_curve(share.x), y = lab_curve(share.y), z = lab_curve(share.z);
  const double lightness = 116.0 * y - 16.0;
  return {lightness, 0.01 * lightness * 500.0 * (x - y), 0.01 * lightness * 200.0 * (y - z)};
}

/// Abasi, Amani Tehran and Fairchild 2020: for distances too large for a Euclidean one.
double hyab(const Vec3& a, const Vec3& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

Planes opponent_planes(const Picture& picture) {
  Planes planes{Plane(picture.width, picture.height), Plane(picture.width, picture.height),
                Plane(picture.width, picture.height)};
  parallel_for(planes[0].values.size(), [&](std::size_t i) {
    const std::uint8_t* bytes = &picture.rgba[4 * i];
    Vec3 rgb;
    for (int c = 0; c < 3; ++c) {
      const double alpha = bytes[3] / 255.0;
      rgb[c] = linear_from_srgb(alpha * bytes[c] / 255.0 + (1.0 - alpha) * 0.5);
    }
    const Vec3 opponent = ycxcz_from_rgb(rgb);
    for (int c = 0; c < 3; ++c) planes[std::size_t(c)].values[i] = static_cast<float>(opponent[c]);
  });
  return planes;
}

// ---- Filters ----

/// The plane filtered along rows or columns; the border repeats.
Plane along_rows(const Plane& plane, const Kernel& kernel) {
  Plane result(plane.width, plane.height);
  const std::vector<float> weights(kernel.weights.begin(), kernel.weights.end());
  parallel_for(
      std::size_t(plane.height),
      [&](std::size_t line) {
        const int y = static_cast<int>(line);
        std::vector<float> padded(std::size_t(plane.width + 2 * kernel.reach));
        const float* from = plane.row(y);
        std::fill_n(padded.begin(), kernel.reach, from[0]);
        std::copy_n(from, plane.width, padded.begin() + kernel.reach);
        std::fill_n(padded.end() - kernel.reach, kernel.reach, from[plane.width - 1]);
        float* to = result.row(y);
        for (std::size_t k = 0; k < weights.size(); ++k)
          for (int x = 0; x < plane.width; ++x) to[x] += weights[k] * padded[k + std::size_t(x)];
      },
      16);
  return result;
}

Plane along_columns(const Plane& plane, const Kernel& kernel) {
  Plane result(plane.width, plane.height);
  parallel_for(
      std::size_t(plane.height),
      [&](std::size_t line) {
        const int y = static_cast<int>(line);
        float* to = result.row(y);
        for (int k = -kernel.reach; k <= kernel.reach; ++k) {
          const float* from = plane.row(std::clamp(y + k, 0, plane.height - 1));
          const auto weight = static_cast<float>(kernel.weights[std::size_t(k + kernel.reach)]);
          for (int x = 0; x < plane.width; ++x) to[x] += weight * from[x];
        }
      },
      16);
  return result;
}

/// One bell of a contrast sensitivity's kernel: height sqrt(pi / width) exp(-pi^2 x^2 / width), x in degrees.
struct Bell {
  double height, width;
};

/// Contrast sensitivity of each opponent channel (Johnson and Fairchild 2003; Movshon and Kiorpes 1988).
const std::array<std::vector<Bell>, 3> sensitivities{{{{1.0, 0.0047}}, {{1.0, 0.0053}}, {{34.1, 0.04}, {13.5, 0.025}}}};

/// What is too fine for the eye is blurred away. A sum of bells is not separable, each of them is.
Plane contrast_filtered(const Plane& plane, const std::vector<Bell>& bells, double pixels_per_degree) {
  constexpr double widest = 0.04;
  const int reach = static_cast<int>(std::ceil(3.0 * std::sqrt(widest / (2.0 * pi * pi)) * pixels_per_degree));
  std::vector<Kernel> kernels;
  std::vector<double> shares;
  for (const Bell& bell : bells) {
    kernels.emplace_back(reach, [&](int i) {
      const double x = i / pixels_per_degree;
      return std::exp(-pi * pi * x * x / bell.width);
    });
    const double sum = kernels.back().sum();
    shares.push_back(bell.height * std::sqrt(pi / bell.width) * sum * sum);
  }
  const double whole = std::accumulate(shares.begin(), shares.end(), 0.0);
  Plane result(plane.width, plane.height);
  for (std::size_t b = 0; b < kernels.size(); ++b) {
    const Kernel kernel = kernels[b].divided(kernels[b].sum());
    const Plane part = along_columns(along_rows(plane, kernel), kernel);
    const auto share = static_cast<float>(shares[b] / whole);
    for (std::size_t i = 0; i < part.values.size(); ++i) result.values[i] += share * part.values[i];
  }
  return result;
}

/// Its positive weights sum to 1 and its negative ones to -1.
Kernel balanced(Kernel kernel) {
  double positive = 0.0, negative = 0.0;
  for (const double weight : kernel.weights) (weight > 0.0 ? positive : negative) += std::abs(weight);
  for (double& weight : kernel.weights) weight /= weight > 0.0 ? positive : negative;
  return kernel;
}

/// How strong edges and points are at every pixel.
struct Features {
  Plane edges, points;
};

/// Of the brightness, 0 to 1, by the first and second derivative of a Gaussian as wide as an edge looks.
Features features(const Plane& brightness, double pixels_per_degree) {
  constexpr double edge_width = 0.082;  // degrees
  const double sigma = 0.5 * edge_width * pixels_per_degree;
  const int reach = static_cast<int>(std::ceil(3.0 * sigma));
  const auto gauss = [&](int x) { return std::exp(-x * x / (2.0 * sigma * sigma)); };
  const Kernel unscaled(reach, gauss);
  const Kernel bell = unscaled.divided(unscaled.sum());
  const Kernel slope = balanced(Kernel(reach, [&](int x) { return -x * gauss(x); }));
  const Kernel curve = balanced(Kernel(reach, [&](int x) { return (x * x / (sigma * sigma) - 1.0) * gauss(x); }));
  const auto magnitude = [&](const Kernel& kernel) {
    Plane across = along_columns(along_rows(brightness, kernel), bell);
    const Plane down = along_columns(along_rows(brightness, bell), kernel);
    for (std::size_t i = 0; i < across.values.size(); ++i)
      across.values[i] = std::hypot(across.values[i], down.values[i]);
    return across;
  };
  return {magnitude(slope), magnitude(curve)};
}

Plane brightness(const Planes& opponent) {
  Plane plane = opponent[0];
  for (float& value : plane.values) value = (value + 16.0f) / 116.0f;
  return plane;
}

// ---- Errors ----

/// Exponents and the knee of the curve that spreads colour distances over 0 to 1.
constexpr double colour_exponent = 0.7, feature_exponent = 0.5, knee_at = 0.4, knee_error = 0.95;

/// The largest distance there is: from green to blue.
double largest_distance() {
  static const double distance = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), colour_exponent);
  return distance;
}

double colour_error(const Vec3& a, const Vec3& b) {
  const double largest = largest_distance(), knee = knee_at * largest;
  const double distance = std::pow(hyab(hunt_lab(a), hunt_lab(b)), colour_exponent);
  if (distance < knee) return distance * knee_error / knee;
  return std::min(1.0, knee_error + (distance - knee) / (largest - knee) * (1.0 - knee_error));
}

Planes seen(const Planes& opponent, double pixels_per_degree) {
  return {contrast_filtered(opponent[0], sensitivities[0], pixels_per_degree),
          contrast_filtered(opponent[1], sensitivities[1], pixels_per_degree),
          contrast_filtered(opponent[2], sensitivities[2], pixels_per_degree)};
}

Vec3 seen_rgb(const Planes& seen, std::size_t pixel) {
  return glm::clamp(rgb_from_ycxcz({seen[0].values[pixel], seen[1].values[pixel], seen[2].values[pixel]}), 0.0, 1.0);
}

}  // namespace

double FlipMap::mean() const {
  if (errors.empty()) return 0.0;
  return std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size());
}

Result<FlipMap> flip(const Picture& a, const Picture& b, double pixels_per_degree) {
  if (a.width != b.width || a.height != b.height)
    return bad_input("the pictures' sizes differ: {}x{} and {}x{}", a.width, a.height, b.width, b.height);
  FlipMap map{a.width, a.height, std::vector<float>(std::size_t(a.width) * a.height)};
  if (map.errors.empty()) return map;
  const Planes opponent_a = opponent_planes(a), opponent_b = opponent_planes(b);
  const Planes seen_a = seen(opponent_a, pixels_per_degree), seen_b = seen(opponent_b, pixels_per_degree);
  const Features features_a = features(brightness(opponent_a), pixels_per_degree);
  const Features features_b = features(brightness(opponent_b), pixels_per_degree);
  parallel_for(map.errors.size(), [&](std::size_t i) {
    const double colour = colour_error(seen_rgb(seen_a, i), seen_rgb(seen_b, i));
    const double edges = std::abs(double(features_a.edges.values[i]) - features_b.edges.values[i]);
    const double points = std::abs(double(features_a.points.values[i]) - features_b.points.values[i]);
    const double feature = std::pow(std::min(1.0, std::max(edges, points) / std::sqrt(2.0)), feature_exponent);
    map.errors[i] = static_cast<float>(std::pow(colour, 1.0 - feature));
  });
  return map;
}

}  // namespace sinew
