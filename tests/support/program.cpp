#include "tests/support/program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <thread>

extern char** environ;

namespace sinew::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// A file without a name: nothing to read while the program runs, so that it can never block on a full pipe.
int nameless_file(const char* label) {
  const int file = memfd_create(label, MFD_CLOEXEC);
  if (file < 0) throw std::runtime_error("memfd_create failed");
  return file;
}

std::string contents(int file) {
  std::string text;
  std::array<char, 65536> block{};
  for (off_t at = 0;; at = static_cast<off_t>(text.size())) {
    const ssize_t count = pread(file, block.data(), block.size(), at);
    if (count <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(count));
  }
}

std::vector<std::string> environment_of(const ProgramOptions& options) {
  std::map<std::string, std::string> variables;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    variables[text.substr(0, text.find('='))] = text.substr(text.find('=') + 1);
  }
  // The user's own choice of device must not decide what a test sees.
  variables.erase("SINEW_DEVICE");
  for (const auto& [name, value] : options.environment) {
    if (value)
      variables[name] = *value;
    else
      variables.erase(name);
  }
  std::vector<std::string> entries;
  for (const auto& [name, value] : variables) entries.push_back(name + "=" + value);
  return entries;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> list;
  for (std::string& text : texts) list.push_back(text.data());
  list.push_back(nullptr);
  return list;
}

std::string shell_command(const Arguments& arguments) {
  std::string text = "sinew";
  for (const std::string& word : arguments) {
    const bool plain = !word.empty() && word.find_first_of(" '\"*?;&|<>()$`\\#") == std::string::npos;
    text += plain ? " " + word : " '" + word + "'";
  }
  return text;
}

pid_t spawn(const Arguments& arguments, const ProgramOptions& options, int out, int err) {
  std::vector<std::string> words{options.program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = environment_of(options);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  if (options.output.empty())
    posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  else
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, options.output.c_str(), O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
  if (!options.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, options.folder.c_str());
  pid_t child = -1;
  const int failed = posix_spawn(&child, words.front().c_str(), &actions, nullptr, pointers(words).data(),
                                 pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) throw std::runtime_error("cannot start " + words.front());
  // Of the child and not of the test, as it starts: long before it writes or takes much memory.
  const auto limit = [&](int resource, const std::optional<std::uint64_t>& bytes) {
    if (!bytes) return;
    const rlimit both{*bytes, *bytes};
    if (prlimit(child, static_cast<__rlimit_resource>(resource), &both, nullptr) != 0)
      throw std::runtime_error("prlimit failed");
  };
  limit(RLIMIT_FSIZE, options.largest_file);
  limit(RLIMIT_AS, options.address_space);
  return child;
}

}  // namespace

std::ostream& operator<<(std::ostream& stream, const ProgramResult& result) {
  stream << "\n  " << result.command << "\n  ended with ";
  if (result.signal != 0)
    stream << "signal " << result.signal;
  else
    stream << "exit code " << result.exit_code;
  return stream << (result.timed_out ? ", killed at its time limit" : "") << "\n  stderr: " << result.err;
}

RunningProgram::RunningProgram(const Arguments& arguments, const ProgramOptions& options)
    : out_(nameless_file("stdout")),
      err_(nameless_file("stderr")),
      begin_(Clock::now()),
      time_limit_(options.time_limit) {
  result_.command = shell_command(arguments);
  child_ = spawn(arguments, options, out_, err_);
}

RunningProgram::~RunningProgram() {
  if (child_ > 0) {
    send(SIGKILL);
    finish();
  }
  close(out_);
  close(err_);
}

std::string RunningProgram::said() const { return contents(err_); }

void RunningProgram::send(int signal) const { kill(child_, signal); }

ProgramResult RunningProgram::finish() {
  int status = 0;
  rusage usage{};
  while (wait4(child_, &status, WNOHANG, &usage) == 0) {
    if (!result_.timed_out && Clock::now() - begin_ > time_limit_) {
      result_.timed_out = true;
      send(SIGKILL);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  child_ = -1;
  result_.seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  if (WIFEXITED(status)) result_.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result_.signal = WTERMSIG(status);
  result_.peak_memory_mib = static_cast<double>(usage.ru_maxrss) / 1024.0;
  result_.out = contents(out_);
  result_.err = contents(err_);
  return result_;
}

ProgramResult run_program(const Arguments& arguments, const ProgramOptions& options) {
  return RunningProgram(arguments, options).finish();
}

std::vector<ProgramResult> run_programs(const std::vector<Arguments>& arguments, const ProgramOptions& options) {
  std::vector<ProgramResult> results(arguments.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < arguments.size(); i = next++) results[i] = run_program(arguments[i], options);
  };
  std::vector<std::jthread> others;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) others.emplace_back(work);
  work();
  others.clear();
  return results;
}

nlohmann::json json_of(const ProgramResult& result) {
  auto json = nlohmann::json::parse(result.out, nullptr, false);
  if (json.is_object()) return json;
  std::ostringstream message;
  message << "stdout is not exactly one JSON object: " << result.out << result;
  throw std::runtime_error(message.str());
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "sinew-test-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::set<std::string> TemporaryFolder::names() const {
  std::set<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(path_))
    found.insert(entry.path().lexically_relative(path_).string());
  return found;
}

ProgramResult ProgramTest::run(const Arguments& arguments, ProgramOptions options) const {
  if (options.folder.empty()) options.folder = folder_.path();
  return run_program(arguments, options);
}

std::vector<ProgramResult> ProgramTest::run_all(const std::vector<Arguments>& arguments, ProgramOptions options) const {
  if (options.folder.empty()) options.folder = folder_.path();
  return run_programs(arguments, options);
}

nlohmann::json ProgramTest::json(Arguments arguments, const ProgramOptions& options) const {
  arguments.emplace_back("--json");
  const ProgramResult result = run(arguments, options);
  EXPECT_EQ(result.exit_code, 0) << result;
  return json_of(result);
}

std::string ProgramTest::arm() const {
  const std::string file = path("arm.glb");
  if (!fs::exists(file)) {
    const ProgramResult result = run({"export", arm_scene, "--rig", "-o", file});
    EXPECT_EQ(result.exit_code, 0) << result;
  }
  return file;
}

void ProgramTest::write(const std::string& name, const std::string& text) const {
  fs::create_directories(fs::path(path(name)).parent_path());
  const auto written = write_file(path(name), text);
  EXPECT_TRUE(written) << written.error().message;
}

Bytes ProgramTest::read(const std::string& name) const {
  auto bytes = read_file(path(name));
  EXPECT_TRUE(bytes) << bytes.error().message;
  return bytes ? std::move(*bytes) : Bytes();
}

DecodedPng ProgramTest::picture(const std::string& name) const {
  auto png = decode_png(read(name));
  EXPECT_TRUE(png) << name << ": " << png.error().message;
  return png ? std::move(*png) : DecodedPng();
}

}  // namespace sinew::test
