#include "engine/view/playback.h"

#include <gtest/gtest.h>

namespace sinew::test {
namespace {

Playback at(double frame, Repeat repeat) {
  Playback playback;
  playback.set_range({10, 20});
  playback.go_to(frame);
  playback.repeat = repeat;
  playback.playing = true;
  return playback;
}

TEST(Playback, StandsStillUnlessItPlays) {
  Playback playback = at(12, Repeat::loop);
  playback.playing = false;
  playback.advance(5.0, 24.0);
  EXPECT_EQ(playback.shown(), 12);
}

TEST(Playback, RunsAtTheScenesRateTimesItsSpeed) {
  Playback playback = at(10, Repeat::loop);
  playback.advance(0.25, 24.0);
  EXPECT_EQ(playback.shown(), 16);
  playback.speed = 0.5;
  playback.advance(0.25, 24.0);
  EXPECT_EQ(playback.shown(), 19);
}

TEST(Playback, ALoopShowsEveryFrameEquallyLong) {
  Playback playback = at(10, Repeat::loop);
  std::vector<int> seen(11, 0);
  for (int i = 0; i < 11 * 8; ++i) {
    ++seen[static_cast<std::size_t>(playback.shown() - 10)];
    playback.advance(1.0 / 64.0, 8.0);  // an eighth of a frame, exact in binary
  }
  for (const int times : seen) EXPECT_EQ(times, 8);
}

TEST(Playback, OnceStopsAtTheEnd) {
  Playback playback = at(18, Repeat::once);
  playback.advance(1.0, 24.0);
  EXPECT_EQ(playback.shown(), 20);
  EXPECT_FALSE(playback.playing);
}

TEST(Playback, PingPongComesBack) {
  Playback playback = at(19, Repeat::ping_pong);
  std::vector<int> seen;
  for (int i = 0; i < 23; ++i) {
    playback.advance(1.0 / 8.0, 8.0);
    seen.push_back(playback.shown());
  }
  EXPECT_EQ(seen, (std::vector<int>{20, 19, 18, 17, 16, 15, 14, 13, 12, 11, 10, 11,
                                    12, 13, 14, 15, 16, 17, 18, 19, 20, 19, 18}));
}

TEST(Playback, StaysWithinItsRange) {
  Playback playback = at(15, Repeat::loop);
  playback.go_to(99);
  EXPECT_EQ(playback.shown(), 20);
  playback.go_to(-3);
  EXPECT_EQ(playback.shown(), 10);
  playback.set_range({12, 12});
  EXPECT_EQ(playback.shown(), 12);
  playback.advance(1.0, 24.0);
  EXPECT_EQ(playback.shown(), 12) << "a range of one frame";
}

TEST(Playback, OneFrameDoesNotPlay) {
  Playback playback;
  playback.set_range({3, 3});
  EXPECT_FALSE(playback.toggle());
  EXPECT_FALSE(playback.playing);
  playback.playing = true;  // a scene of one frame came while another was playing
  playback.advance(0.1, 24.0);
  EXPECT_FALSE(playback.playing);
  EXPECT_EQ(playback.shown(), 3);
}

TEST(Playback, PlaysAgainFromTheBeginningAfterTheEnd) {
  Playback playback = at(20, Repeat::once);
  playback.playing = false;
  EXPECT_TRUE(playback.toggle());
  EXPECT_TRUE(playback.playing);
  EXPECT_EQ(playback.shown(), 10);
  EXPECT_TRUE(playback.toggle());
  EXPECT_FALSE(playback.playing);
  playback.go_to(15);
  EXPECT_TRUE(playback.toggle());
  EXPECT_EQ(playback.shown(), 15) << "a pause goes on where it was";
}

}  // namespace
}  // namespace sinew::test
