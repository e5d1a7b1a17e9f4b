#include "engine/core/ordered_work.h"

#include <atomic>
#include <memory>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace sinew {
namespace {

using namespace std::chrono_literals;

TEST(OrderedWork, OutcomesComeInTheOrderOfTheItemsHoweverLongEachTakes) {
  OrderedWork<int, int> work(4, 8, [](int item) {
    std::this_thread::sleep_for(std::chrono::microseconds(item * 7919 % 2000));
    return 10 * item;
  });
  std::vector<int> outcomes;
  for (int i = 0; i < 200; ++i) {
    work.add(i);
    while (const auto ready = work.take_ready()) outcomes.push_back(*ready);
  }
  while (const auto next = work.take_next()) outcomes.push_back(*next);
  ASSERT_EQ(outcomes.size(), 200u);
  for (int i = 0; i < 200; ++i) EXPECT_EQ(outcomes[static_cast<std::size_t>(i)], 10 * i);
}

TEST(OrderedWork, NoMoreItemsThanPlacesAreAliveAtATime) {
  struct Counted {
    explicit Counted(std::atomic<int>& alive) : alive_(&alive) { ++alive; }
    Counted(Counted&& other) noexcept : alive_(std::exchange(other.alive_, nullptr)) {}
    ~Counted() {
      if (alive_ != nullptr) --*alive_;
    }
    std::atomic<int>* alive_;
  };
  std::atomic<int> alive{0}, most{0};
  {
    OrderedWork<std::shared_ptr<Counted>, int> work(2, 3, [&](const std::shared_ptr<Counted>&) {
      most = std::max(most.load(), alive.load());
      std::this_thread::sleep_for(1ms);
      return 0;
    });
    for (int i = 0; i < 30; ++i) work.add(std::make_shared<Counted>(alive));
  }
  EXPECT_EQ(alive, 0);
  EXPECT_GE(most, 2) << "nothing ever waited";
  // Three in their places, and the one that its maker wants to add.
  EXPECT_LE(most, 4);
}

TEST(OrderedWork, SeveralAreWorkedOnAtATime) {
  std::atomic<int> begun{0};
  OrderedWork<int, bool> work(2, 2, [&](int) {
    ++begun;
    // Ends only if the other one begins as well.
    const auto deadline = std::chrono::steady_clock::now() + 10s;
    while (begun < 2 && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
    return begun >= 2;
  });
  work.add(0);
  work.add(1);
  EXPECT_TRUE(work.take_next().value());
  EXPECT_TRUE(work.take_next().value());
  EXPECT_FALSE(work.take_next());
}

TEST(OrderedWork, WhatTheWorkThrowsComesWithItsOutcome) {
  OrderedWork<int, int> work(1, 2, [](int item) {
    if (item == 1) throw std::runtime_error("one");
    return item;
  });
  for (int i = 0; i < 3; ++i) work.add(i);
  EXPECT_EQ(work.take_next(), 0);
  EXPECT_THROW(work.take_next(), std::runtime_error);
  EXPECT_EQ(work.take_next(), 2);
}

TEST(OrderedWork, FinishesWhatWasAddedWhenItIsDropped) {
  std::atomic<int> done{0};
  {
    OrderedWork<int, int> work(2, 10, [&](int) {
      std::this_thread::sleep_for(1ms);
      return ++done;
    });
    for (int i = 0; i < 10; ++i) work.add(i);
  }
  EXPECT_EQ(done, 10);
}

}  // namespace
}  // namespace sinew
