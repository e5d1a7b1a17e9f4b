#pragma once
/// The program as a user starts it: a child process with its own arguments, environment and working folder.

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "engine/core/files.h"
#include "engine/io/png.h"

namespace sinew::test {

using Arguments = std::vector<std::string>;

/// An arm that curls: small, and with one joint after another.
inline const std::string arm_scene = std::string(SINEW_SOURCE_DIR) + "/scenes/arm.json";

struct ProgramOptions {
  /// Over the test's own environment; nullopt takes a variable away.
  std::map<std::string, std::optional<std::string>> environment{};
  std::filesystem::path program = SINEW_PROGRAM;
  std::filesystem::path folder{};                ///< working folder; empty: the test's own
  std::filesystem::path output{};                ///< where stdout goes instead of being captured
  std::chrono::milliseconds time_limit{60'000};  ///< after which the program is killed
  std::optional<std::uint64_t> largest_file{};   ///< bytes: a write beyond fails like one to a full disk
  std::optional<std::uint64_t> address_space{};  ///< bytes: an allocation beyond fails
};

/// How a run ended and what it said.
struct ProgramResult {
  std::string command;     ///< as a shell would take it
  int exit_code = -1;      ///< -1 where a signal ended it
  int signal = 0;          ///< that ended it
  bool timed_out = false;  ///< it was killed at the time limit
  std::string out, err;
  double seconds = 0.0;        ///< by the clock on the wall
  double peak_memory_mib = 0;  ///< largest resident set
};

/// The command, how it ended and its stderr: for a test's message.
std::ostream& operator<<(std::ostream& stream, const ProgramResult& result);

/// Started on construction, killed on destruction if it still runs. Its stdin is empty.
class RunningProgram {
 public:
  RunningProgram(const Arguments& arguments, const ProgramOptions& options = {});
  ~RunningProgram();
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  void send(int signal) const;
  /// What it has written to stderr so far.
  std::string said() const;
  pid_t id() const { return child_; }
  /// Waits for its end, at most until the time limit.
  ProgramResult finish();

 private:
  pid_t child_ = -1;
  int out_ = -1, err_ = -1;
  std::chrono::steady_clock::time_point begin_;
  std::chrono::milliseconds time_limit_;
  ProgramResult result_;
};

ProgramResult run_program(const Arguments& arguments, const ProgramOptions& options = {});

/// Runs them all, as many at a time as there are cores; the results are in the arguments' order.
std::vector<ProgramResult> run_programs(const std::vector<Arguments>& arguments, const ProgramOptions& options = {});

/// What `--json` printed. Throws where stdout is anything but exactly one object: no test can go on without it.
nlohmann::json json_of(const ProgramResult& result);

/// An empty folder that is removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Of everything in it, hidden files too, relative to it.
  std::set<std::string> names() const;

 private:
  std::filesystem::path path_;
};

/// Each test has a folder of its own, in which the program runs unless the options name another.
class ProgramTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::set<std::string> names() const { return folder_.names(); }

  ProgramResult run(const Arguments& arguments, ProgramOptions options = {}) const;
  std::vector<ProgramResult> run_all(const std::vector<Arguments>& arguments, ProgramOptions options = {}) const;
  /// The object that a run with `--json` appended prints. The test fails where the exit code is not 0.
  nlohmann::json json(Arguments arguments, const ProgramOptions& options = {}) const;

  /// The built-in arm as a file of its own, for scenes that name a model.
  std::string arm() const;
  void write(const std::string& name, const std::string& text) const;
  Bytes read(const std::string& name) const;
  DecodedPng picture(const std::string& name) const;

 private:
  TemporaryFolder folder_;
};

}  // namespace sinew::test
