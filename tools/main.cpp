/// sinew: a character deformer and renderer. Each command stands in a file cmd_<name>.cpp.

#include <algorithm>
#include <iostream>
#include <system_error>

#include <spdlog/spdlog.h>

#include "engine/app/version.h"
#include "engine/core/interrupt.h"
#include "engine/core/text.h"
#include "tools/command.h"

namespace {

using namespace sinew;
using namespace sinew::tools;

int exit_code(ErrorKind kind) { return static_cast<int>(kind); }

/// What to say where the first word is meant as a command and is none.
std::optional<std::string> unknown_command(const CLI::App& program, int count, char** words) {
  if (count < 2 || words[1][0] == '-') return std::nullopt;
  std::vector<std::string> known;
  for (const CLI::App* command : program.get_subcommands(nullptr)) known.push_back(command->get_name());
  if (std::find(known.begin(), known.end(), words[1]) != known.end()) return std::nullopt;
  return fmt::format("there is no command \"{}\"{}; there are {}", words[1], did_you_mean(words[1], known),
                     fmt::join(known, ", "));
}

/// What to say where a word looks like an option of the command and is none.
std::optional<std::string> unknown_option(const CLI::App& program, int count, char** words) {
  const CLI::App* command = &program;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  if (command == &program) return std::nullopt;
  std::vector<std::string> all, shown;
  for (const CLI::Option* option : command->get_options())
    for (const std::string& name : option->get_lnames()) {
      all.push_back("--" + name);
      // Those without a group are known only to be refused.
      if (!option->get_group().empty()) shown.push_back("--" + name);
    }
  for (int i = 2; i < count; ++i) {
    const std::string word = std::string(words[i]).substr(0, std::string_view(words[i]).find('='));
    if (!word.starts_with("--") || std::find(all.begin(), all.end(), word) != all.end()) continue;
    return fmt::format("{} has no option {}{}", command->get_name(), word, did_you_mean(word, shown));
  }
  return std::nullopt;
}

/// A report that does not reach its reader is an output that cannot be written.
int flush_report() {
  if (std::cout.flush()) return 0;
  spdlog::error("the report cannot be written to stdout");
  return exit_code(ErrorKind::cannot_write);
}

int run_program(int count, char** words) {
  CLI::App program("sinew: skinned characters that flex, in pictures made by Vulkan compute");
  program.set_version_flag("--version", "sinew " + version());
  program.require_subcommand(1);
  Run run;
  add_render(program, run);
  add_info(program, run);
  add_parity(program, run);
  add_export(program, run);
  add_bench(program, run);
  add_muscles(program, run);
  add_compare(program, run);
  add_figure(program, run);
  add_motion(program, run);
  add_head(program, run);
  add_fit_skin(program, run);
  add_view(program, run);
  add_bind(program, run);
  add_weights(program, run);
  try {
    program.parse(count, words);
  } catch (const CLI::Success& asked) {
    return program.exit(asked);
  } catch (const CLI::ExtrasError& extra) {
    const auto said = unknown_command(program, count, words);
    std::cerr << "error: " << (said ? said : unknown_option(program, count, words)).value_or(extra.what())
              << "\nRun with --help for more information.\n";
    return exit_code(ErrorKind::usage);
  } catch (const CLI::ParseError& wrong) {
    std::cerr << "error: " << unknown_command(program, count, words).value_or(wrong.what())
              << "\nRun with --help for more information.\n";
    return exit_code(ErrorKind::usage);
  }
  const Result<void> done = run();
  if (done) return flush_report();
  spdlog::error("{}", done.error().message);
  return exit_code(done.error().kind);
}

}  // namespace

int main(int count, char** words) {
  apply_verbosity({});
  catch_interrupts();
  try {
    return run_program(count, words);
  } catch (const std::bad_alloc&) {
    spdlog::error("out of memory");
    return exit_code(ErrorKind::device_failed);
  } catch (const std::exception& error) {
    const auto* system = dynamic_cast<const std::system_error*>(&error);
    const bool no_thread = system != nullptr && system->code() == std::errc::resource_unavailable_try_again;
    spdlog::error("{}: {}", no_thread ? "no thread is to be had" : "unexpected", error.what());
    return exit_code(no_thread ? ErrorKind::device_failed : ErrorKind::bad_input);
  }
}
