#include "engine/view/file_watch.h"

#include <thread>

#include <gtest/gtest.h>

#include "engine/core/files.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

/// It asks the disk four times a second: after this it has asked.
constexpr std::chrono::milliseconds long_enough(300);

TEST(FileWatch, TellsEveryChangeOnce) {
  const fs::path file = fs::path(::testing::TempDir()) / "file_watch_test.json";
  ASSERT_TRUE(write_file(file, std::string("one")));
  FileWatch watch;
  EXPECT_FALSE(watch.has_changed()) << "nothing is watched yet";
  watch.watch(file);
  EXPECT_FALSE(watch.has_changed());
  ASSERT_TRUE(write_file(file, std::string("two, and longer")));
  std::this_thread::sleep_for(long_enough);
  EXPECT_TRUE(watch.has_changed());
  std::this_thread::sleep_for(long_enough);
  EXPECT_FALSE(watch.has_changed());
  fs::remove(file);
  std::this_thread::sleep_for(long_enough);
  EXPECT_FALSE(watch.has_changed()) << "an editor may be about to write it anew";
  ASSERT_TRUE(write_file(file, std::string("three")));
  std::this_thread::sleep_for(long_enough);
  EXPECT_TRUE(watch.has_changed());
  ASSERT_TRUE(write_file(file, std::string("my own")));
  watch.watch(file);
  EXPECT_FALSE(watch.has_changed()) << "what was there when watching began is no change";
  fs::remove(file);
}

TEST(FileWatch, TellsOfEveryFileInAFolder) {
  const fs::path folder = fs::path(::testing::TempDir()) / "file_watch_test";
  fs::create_directories(folder);
  ASSERT_TRUE(write_file(folder / "one.frag", std::string("one")));
  ASSERT_TRUE(write_file(folder / "two.glsl", std::string("two")));
  FileWatch watch;
  watch.watch(folder);
  EXPECT_FALSE(watch.has_changed());
  ASSERT_TRUE(write_file(folder / "one.frag", std::string("one, changed")));
  ASSERT_TRUE(write_file(folder / "two.glsl", std::string("two, changed")));
  std::this_thread::sleep_for(long_enough);
  EXPECT_TRUE(watch.has_changed());
  std::this_thread::sleep_for(long_enough);
  EXPECT_FALSE(watch.has_changed()) << "both were told at once";
  ASSERT_TRUE(write_file(folder / "three.glsl", std::string("new")));
  std::this_thread::sleep_for(long_enough);
  EXPECT_TRUE(watch.has_changed());
  fs::remove(folder / "three.glsl");
  std::this_thread::sleep_for(long_enough);
  EXPECT_FALSE(watch.has_changed()) << "an editor may be about to write it anew";
  fs::remove_all(folder);
}

}  // namespace
}  // namespace sinew::test
