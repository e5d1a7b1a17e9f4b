#include "engine/render/coverage.h"

#include <cstdint>
#include <cstdlib>

namespace sinew {
namespace {

constexpr int grid = 256;

/// Corners farther out than this are pulled in, so that differences of coordinates stay accurate.
constexpr double farthest_corner = 1e9;

/// Bounds the memory of one pass; larger shapes are done in several bands of rows.
constexpr int most_cells = 1 << 20;

/// A half-open box of pixels.
struct PixelBox {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// Signed areas gathered cell by cell over a band of rows. An edge adds to the cell that it crosses the height that it
/// covers there and the area to its left; summing along a row then gives each pixel's area (as FreeType's smooth
/// rasteriser does it).
class Band {
 public:
  explicit Band(const PixelBox& box) : box_(box), columns_(box.right - box.left + 1), rows_(box.bottom - box.top) {
    cells_.resize(std::size_t(columns_) * rows_);
    touched_.assign(rows_, {columns_, -1});
  }

  /// Clips in floating point, then adds what is left. What lies left of the box still decides what is inside and is
  /// moved to the left border; what lies right of it decides nothing that is visible.
  void add_edge(Vec2 a, Vec2 b) {
    const double sense = a.y < b.y ? 1.0 : -1.0;
    if (sense < 0.0) std::swap(a, b);
    const double top = box_.top, bottom = box_.bottom;
    if (!(a.y < bottom && b.y > top && a.y < b.y)) return;
    const auto at_y = [&](double y) {
      const double x = a.x + (y - a.y) * ((b.x - a.x) / (b.y - a.y));
      return Vec2(std::clamp(x, std::min(a.x, b.x), std::max(a.x, b.x)), y);
    };
    const Vec2 first = a.y < top ? at_y(top) : a, last = b.y > bottom ? at_y(bottom) : b;
    double parts[4] = {0.0, 1.0, 1.0, 1.0};
    int count = 1;
    const Vec2 step = last - first;
    for (const double border : {double(box_.left), double(box_.right)}) {
      const double part = (border - first.x) / step.x;
      if (part > 0.0 && part < 1.0) parts[count++] = part;
    }
    if (count == 3 && parts[1] > parts[2]) std::swap(parts[1], parts[2]);
    for (int i = 0; i < count; ++i) {
      const Vec2 p = first + parts[i] * step, q = i + 1 == count ? last : first + parts[i + 1] * step;
      add_inside(quantised(p), quantised(q), int(sense));
    }
  }

  void emit_rows(const std::function<void(const CoverageRow&)>& emit) {
    std::vector<int> coverage;
    for (int row = 0; row < rows_; ++row) {
      const auto [first, last] = touched_[row];
      if (first > last) continue;
      coverage.clear();
      std::int64_t height = 0;
      for (int column = first; column <= std::min(last, columns_ - 2); ++column) {
        const Cell& cell = cells_[std::size_t(row) * columns_ + column];
        height += cell.height;
        coverage.push_back(int(std::min<std::int64_t>(std::abs(height * 2 * grid - cell.area), full_coverage)));
      }
      if (!coverage.empty()) emit({box_.left + first, box_.top + row, coverage});
    }
  }

 private:
  struct Cell {
    std::int32_t height = 0;
    std::int32_t area = 0;  ///< twice the area left of the edges
  };
  struct GridPoint {
    std::int64_t x = 0, y = 0;
  };

  GridPoint quantised(const Vec2& p) const {
    const auto rounded = [](double v, int low, int high) {
      return std::clamp<std::int64_t>(std::int64_t(std::floor((v - low) * grid + 0.5)), 0,
                                      std::int64_t(high - low) * grid);
    };
    return {rounded(p.x, box_.left, box_.right), rounded(p.y, box_.top, box_.bottom)};
  }

  static std::int64_t divide_rounded(std::int64_t numerator, std::int64_t denominator) {
    const std::int64_t half = denominator / 2;
    return numerator >= 0 ? (numerator + half) / denominator : -((-numerator + half) / denominator);
  }

  void add_inside(const GridPoint& a, const GridPoint& b, int sense) {
    if (a.y == b.y) return;
    const auto x_at = [&](std::int64_t y) { return a.x + divide_rounded((b.x - a.x) * (y - a.y), b.y - a.y); };
    for (std::int64_t row = a.y / grid; row * grid < b.y; ++row) {
      const std::int64_t from = std::max(a.y, row * grid), to = std::min(b.y, (row + 1) * grid);
      add_in_row(int(row), x_at(from), x_at(to), to - from, sense);
    }
  }

  void add_in_row(int row, std::int64_t x0, std::int64_t x1, std::int64_t height, int sense) {
    const std::int64_t left = std::min(x0, x1), right = std::max(x0, x1);
    const int first = int(left / grid), last = int(right / grid);
    touched_[row].first = std::min(touched_[row].first, first);
    touched_[row].second = std::max(touched_[row].second, last);
    Cell* cells = &cells_[std::size_t(row) * columns_];
    std::int64_t done = 0, from = left;
    for (int column = first; column <= last; ++column) {
      const std::int64_t to = std::min(right, (column + 1) * std::int64_t{grid});
      const std::int64_t until = to == right ? height : divide_rounded(height * (to - left), right - left);
      const std::int64_t base = column * std::int64_t{grid};
      cells[column].height += int(sense * (until - done));
      cells[column].area += int(sense * (until - done) * (from + to - 2 * base));
      done = until;
      from = to;
    }
  }

  PixelBox box_;
  int columns_, rows_;  ///< one column more than pixels: for edges on the right border
  std::vector<Cell> cells_;
  std::vector<std::pair<int, int>> touched_;  ///< [rows] first and last column
};

Vec2 pulled_in(const Vec2& p) { return glm::clamp(p, Vec2(-farthest_corner), Vec2(farthest_corner)); }

}  // namespace

void rasterise(std::span<const Contour> contours, int width, int height,
               const std::function<void(const CoverageRow&)>& emit) {
  Vec2 low(INFINITY), high(-INFINITY);
  for (const Contour& contour : contours) {
    for (const Vec2& p : contour) {
      if (!std::isfinite(p.x) || !std::isfinite(p.y)) return;
      low = glm::min(low, pulled_in(p));
      high = glm::max(high, pulled_in(p));
    }
  }
  if (!(low.x < width && low.y < height && high.x > 0.0 && high.y > 0.0)) return;
  // A pixel of room: rounding to the grid may carry a corner over a pixel's border.
  const PixelBox all{std::max(0, int(std::max(low.x, 0.0)) - 1), std::max(0, int(std::max(low.y, 0.0)) - 1),
                     int(std::min(high.x + 2.0, double(width))), int(std::min(high.y + 2.0, double(height)))};
  const int rows = std::max(1, most_cells / (all.right - all.left + 1));
  for (int top = all.top; top < all.bottom; top += rows) {
    Band band({all.left, top, all.right, std::min(top + rows, all.bottom)});
    for (const Contour& contour : contours)
      for (std::size_t i = 0; i < contour.size(); ++i)
        band.add_edge(pulled_in(contour[i]), pulled_in(contour[(i + 1) % contour.size()]));
    band.emit_rows(emit);
  }
}

}  // namespace sinew
