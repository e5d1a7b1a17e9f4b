#include "engine/core/files.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>

namespace sinew {
namespace {

namespace fs = std::filesystem;

Bytes bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

/// A folder of its own for each test.
class Files : public testing::Test {
 protected:
  Files() : folder_(fs::path(testing::TempDir()) / fmt::format("sinew_files_{}", ::getpid())) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~Files() override { fs::remove_all(folder_); }

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : fs::directory_iterator(folder_)) all.push_back(entry.path().filename().string());
    std::sort(all.begin(), all.end());
    return all;
  }
  static void expect_refused(const Result<void>& result, ErrorKind kind, const std::string& part) {
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().kind, kind);
    EXPECT_NE(result.error().message.find(part), std::string::npos) << result.error().message;
  }
  static void expect_refused(const Result<Bytes>& result, const std::string& part) {
    expect_refused(result ? Result<void>() : Result<void>(tl::unexpected<Error>(result.error())), ErrorKind::bad_input,
                   part);
  }

  fs::path folder_;
};

TEST_F(Files, WhatIsWrittenIsReadBack) {
  Bytes data(100'000);
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = static_cast<unsigned char>(i * 31 >> 3);
  ASSERT_TRUE(write_file(folder_ / "a.bin", data));
  EXPECT_EQ(read_file(folder_ / "a.bin").value(), data);
  ASSERT_TRUE(write_file(folder_ / "a.bin", std::string("shorter")));
  EXPECT_EQ(read_file(folder_ / "a.bin").value(), bytes_of("shorter"));
  ASSERT_TRUE(write_file(folder_ / "empty", std::string()));
  EXPECT_TRUE(read_file(folder_ / "empty").value().empty());
  EXPECT_EQ(names(), (std::vector<std::string>{"a.bin", "empty"}));
}

TEST_F(Files, OnlyWholeRegularFilesUpToTheLimitAreRead) {
  ASSERT_TRUE(write_file(folder_ / "six", std::string("123456")));
  EXPECT_EQ(read_file(folder_ / "six", 6).value().size(), 6u);
  expect_refused(read_file(folder_ / "six", 5), "6 bytes are more than the 5");
  expect_refused(read_file(folder_ / "none"), (folder_ / "none").string() + ": no such file");
  expect_refused(read_file(folder_), "is a folder");
  expect_refused(read_file("/dev/zero"), "not a regular file");
  ASSERT_EQ(::mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  expect_refused(read_file(folder_ / "pipe"), "not a regular file");
}

TEST_F(Files, AFailedWriteLeavesWhatStoodThere) {
  const fs::path file = folder_ / "a.txt";
  ASSERT_TRUE(write_file(file, std::string("before")));
  rlimit old{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &old), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, old.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto result = write_file(file, std::string(5000, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, handler);
  expect_refused(result, ErrorKind::cannot_write, file.string());
  EXPECT_EQ(read_file(file).value(), bytes_of("before"));
  EXPECT_EQ(names(), (std::vector<std::string>{"a.txt"}));
}

TEST_F(Files, WhatCannotBeWrittenIsNamed) {
  expect_refused(write_file(folder_, std::string("x")), ErrorKind::cannot_write, "is a folder");
  expect_refused(write_file(folder_ / "no" / "a", std::string("x")), ErrorKind::cannot_write, "No such file");
  EXPECT_TRUE(names().empty());
}

TEST_F(Files, DevicesAreWrittenTo) {
  // By links of our own: were a device replaced like a file, only the link would go, and not the machine's /dev/null.
  fs::create_symlink("/dev/null", folder_ / "null");
  fs::create_symlink("/dev/full", folder_ / "full");
  EXPECT_TRUE(check_writable(folder_ / "null"));
  EXPECT_TRUE(write_file(folder_ / "null", std::string("x")));
  EXPECT_TRUE(fs::is_character_file(folder_ / "null"));
  expect_refused(write_file(folder_ / "full", std::string("x")), ErrorKind::cannot_write, "full");
  EXPECT_EQ(names(), (std::vector<std::string>{"full", "null"}));
}

TEST_F(Files, WritersAtTheSameTimeDoNotMix) {
  const fs::path file = folder_ / "a.txt";
  std::vector<std::thread> writers;
  for (const char letter : {'a', 'b', 'c', 'd'})
    writers.emplace_back([&file, letter] {
      for (int i = 0; i < 20; ++i) EXPECT_TRUE(write_file(file, std::string(10'000, letter)));
    });
  for (std::thread& writer : writers) writer.join();
  const Bytes data = read_file(file).value();
  EXPECT_EQ(data, Bytes(10'000, data.front()));
  EXPECT_EQ(names(), (std::vector<std::string>{"a.txt"}));
}

TEST_F(Files, AskingWhetherAFileCanBeWrittenLeavesNoTrace) {
  EXPECT_TRUE(check_writable(folder_ / "new"));
  EXPECT_TRUE(names().empty());
  ASSERT_TRUE(write_file(folder_ / "old", std::string("kept")));
  EXPECT_TRUE(check_writable(folder_ / "old"));
  EXPECT_EQ(read_file(folder_ / "old").value(), bytes_of("kept"));
  expect_refused(check_writable(folder_), ErrorKind::cannot_write, "is a folder");
  expect_refused(check_writable(folder_ / "no" / "a"), ErrorKind::cannot_write, "does not exist");
  EXPECT_EQ(names(), (std::vector<std::string>{"old"}));
}

TEST_F(Files, ANameWithoutAFolderIsInThisOne) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  EXPECT_TRUE(check_writable("here"));
  EXPECT_TRUE(write_file("here", std::string("x")));
  fs::current_path(before);
  EXPECT_EQ(names(), (std::vector<std::string>{"here"}));
}

TEST(Sha256, GivesTheStandardsExamples) {
  // FIPS 180-2, appendix B.
  EXPECT_EQ(sha256(std::string()), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256(std::string("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace
}  // namespace sinew
