#include "engine/render/wire.h"

#include "tests/render/stage_set.h"

namespace sinew::test {
namespace {

class Wires : public DeviceTest {};

int darkness(const Rgba& c) { return 3 * 255 - c[0] - c[1] - c[2]; }

/// A white square before a smaller one.
Model two_squares() {
  Squares squares;
  squares.add({0, 0, 0.5}, 0.9);
  squares.add({0, 0, 0}, 0.5);
  return squares.model;
}

TEST_F(Wires, EdgesAreDrawnWhereTheyAre) {
  const Picture picture = drawn(two_squares(), {.wire = WireMode::visible});
  // The near square's left edge stands at -0.9 of 1.206: pixel 8; its diagonal runs through the middle.
  int darkest = 0;
  for (int x = 6; x <= 10; ++x) darkest = std::max(darkest, darkness(at(picture, x, 40)));
  EXPECT_GT(darkest, 250);
  EXPECT_GT(darkness(at(picture, 32, 32)) + darkness(at(picture, 31, 32)), 250);
  EXPECT_EQ(darkness(at(picture, 20, 14)), 0) << "between edges";
  EXPECT_EQ(darkness(at(picture, 2, 32)), 0) << "beside the mesh";
}

TEST_F(Wires, HiddenEdgesAreLeftOutOrFaint) {
  const Picture visible = drawn(two_squares(), {.wire = WireMode::visible}),
                all = drawn(two_squares(), {.wire = WireMode::all});
  // The far square's left edge: -0.5 of 1.34, pixel 20.
  const auto darkest = [](const Picture& picture) {
    int most = 0;
    for (int x = 18; x <= 22; ++x) most = std::max(most, darkness(at(picture, x, 36)));
    return most;
  };
  EXPECT_EQ(darkest(visible), 0);
  EXPECT_GT(darkest(all), 40);
  EXPECT_LT(darkest(all), 250);
}

TEST(DistinctEdges, EachOnceRising) {
  const std::vector<std::uint32_t> square{0, 1, 2, 0, 2, 3, 3, 2, 0};
  EXPECT_EQ(distinct_edges(square), (std::vector<std::uint32_t>{0, 1, 0, 2, 0, 3, 1, 2, 2, 3}));
  EXPECT_TRUE(distinct_edges({}).empty());
}

}  // namespace
}  // namespace sinew::test
