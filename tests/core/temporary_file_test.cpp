#include "engine/core/temporary_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <set>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "engine/core/files.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

class Temporary : public testing::Test {
 protected:
  Temporary() : folder_(fs::path(testing::TempDir()) / fmt::format("sinew_temporary_{}", ::getpid())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Temporary() override { fs::remove_all(folder_); }

  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_)) all.insert(entry.path().filename().string());
    return all;
  }
  /// What a killed program leaves: there, and locked by nobody.
  void leave(const std::string& name) const {
    const int file = ::open((folder_ / name).c_str(), O_WRONLY | O_CREAT, 0666);
    ASSERT_GE(file, 0);
    ::close(file);
  }
  std::string named(const char* name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

TEST_F(Temporary, IsHiddenUntilItAppears) {
  auto file = TemporaryFile::create(folder_ / "x.png");
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(names().size(), 1u);
  EXPECT_TRUE(names().begin()->starts_with(".x.png.")) << *names().begin();
  const std::string text = "whole";
  ASSERT_TRUE(file->write(std::span(reinterpret_cast<const unsigned char*>(text.data()), text.size())));
  ASSERT_TRUE(file->appear());
  EXPECT_EQ(names(), std::set<std::string>{"x.png"});
  EXPECT_EQ(read_file(folder_ / "x.png").value().size(), 5u);
}

TEST_F(Temporary, DroppedLeavesNothing) {
  { ASSERT_TRUE(TemporaryFile::create(folder_ / "x.png")); }
  EXPECT_TRUE(names().empty());
}

TEST_F(Temporary, WhatKilledProgramsLeftOfTheSameSequenceIsRemoved) {
  for (const char* name : {".x_0001.png.12-3.part", ".x_0002.png.999999-0.part", ".x_12345.png.1-1.part"}) leave(name);
  const std::set<std::string> others{".x_0001.png.12-3.part.png", ".x_1.png.12-3.part",  ".y_0001.png.12-3.part",
                                     ".x_0001.png.12-.part",      ".x_0001.png.part",    "x_0001.png.12-3.part",
                                     ".x_000a.png.12-3.part",     ".x_0001.jpg.1-2.part"};
  for (const std::string& name : others) leave(name);
  leave("x_0001.png");
  remove_stale_temporaries(named("x_####.png"));
  std::set<std::string> kept = others;
  kept.insert("x_0001.png");
  EXPECT_EQ(names(), kept);
}

TEST_F(Temporary, OfOneFileOnlyItsOwnAreRemoved) {
  leave(".film.mp4.12-3.part");
  leave(".film2.mp4.12-3.part");
  remove_stale_temporaries(named("film.mp4"));
  EXPECT_EQ(names(), std::set<std::string>{".film2.mp4.12-3.part"});
}

TEST_F(Temporary, WhatIsStillWrittenStays) {
  auto mine = TemporaryFile::create(folder_ / "x.png");
  ASSERT_TRUE(mine) << mine.error().message;
  remove_stale_temporaries(named("x.png"));
  EXPECT_EQ(names().size(), 1u);
  EXPECT_TRUE(mine->appear());
}

TEST_F(Temporary, WhatAnotherProcessWritesStaysUntilThatIsKilled) {
  int told[2];
  ASSERT_EQ(::pipe(told), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const auto file = TemporaryFile::create(folder_ / "x.png");
    const char ready = file ? 'y' : 'n';
    if (::write(told[1], &ready, 1) != 1) ::_exit(1);
    while (true) ::pause();
  }
  char ready = 0;
  ASSERT_EQ(::read(told[0], &ready, 1), 1);
  EXPECT_EQ(ready, 'y');
  remove_stale_temporaries(named("x.png"));
  EXPECT_EQ(names().size(), 1u) << "a living process' file was taken away";
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(names().size(), 1u);
  remove_stale_temporaries(named("x.png"));
  EXPECT_TRUE(names().empty());
  ::close(told[0]);
  ::close(told[1]);
}

TEST_F(Temporary, NoFileIsLostToOneThatTidiesUpAtTheSameTime) {
  std::atomic<bool> done{false};
  std::jthread tidier([&] {
    while (!done) remove_stale_temporaries(named("x_####.txt"));
  });
  for (int i = 0; i < 300; ++i) {
    const auto written = write_file(folder_ / fmt::format("x_{:04}.txt", i), std::string("text"));
    ASSERT_TRUE(written) << written.error().message;
  }
  done = true;
  tidier.join();
  EXPECT_EQ(names().size(), 300u);
}

TEST_F(Temporary, LinksAreNotFollowed) {
  leave("precious");
  fs::create_symlink(folder_ / "precious", folder_ / ".x.png.1-2.part");
  remove_stale_temporaries(named("x.png"));
  EXPECT_TRUE(fs::exists(folder_ / "precious"));
}

TEST_F(Temporary, AFolderThatIsNotThereIsNoMistake) { remove_stale_temporaries(named("absent/x.png")); }

}  // namespace
}  // namespace sinew
