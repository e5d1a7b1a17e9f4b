#include "engine/motion/curve_plot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "engine/core/files.h"
#include "engine/core/temporary_file.h"
#include "engine/core/text.h"

extern char** environ;

namespace sinew {
namespace {

namespace fs = std::filesystem;

/// A text within gnuplot's single quotes, no markup in it.
std::string quoted(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) safe += c == '\'' ? std::string("''") : std::string(1, c < ' ' && c >= 0 ? ' ' : c);
  return safe + "'";
}

void append_rows(std::string& script, const std::string& name, const std::vector<double>& x,
                 const std::vector<double>& y) {
  script += "$" + name + " << EOD\n";
  for (std::size_t i = 0; i < x.size(); ++i) script += fmt::format("{:.9g} {:.9g}\n", x[i], y[i]);
  script += "EOD\n";
}

std::string script_of(const CurvePlot& plot, const std::string& terminal, const fs::path& output) {
  const PiecewisePolynomial& curve = plot.curve;
  std::string script;
  append_rows(script, "samples", plot.times, plot.values);
  std::vector<double> residual, x, y;
  for (std::size_t i = 0; i < plot.times.size(); ++i) residual.push_back(plot.values[i] - curve.value(plot.times[i]));
  append_rows(script, "residual", plot.times, residual);
  for (int i = 0; i <= 2000; ++i) {
    x.push_back(curve.begin() + (curve.end() - curve.begin()) * i / 2000.0);
    y.push_back(curve.value(x.back()));
  }
  append_rows(script, "curve", x, y);
  script += fmt::format("set terminal {} size {},{} noenhanced background '#ffffff' font 'DejaVu Sans,13'\n", terminal,
                        plot.width, plot.height);
  script += "set output " + quoted(output.string()) + "\n";
  script += "set multiplot\nset lmargin 11\nset rmargin 3\nset grid lc rgb '#dddddd'\nset border lc rgb '#444444'\n";
  // Many cuts are thin lines that leave the curve to be seen.
  const char* cut_style = curve.segments() > 40 ? "lc rgb '#e0b8a0' lw 0.6" : "lc rgb '#c06030' lw 1.2 dt 2";
  for (std::size_t i = 1; i < curve.segments(); ++i)
    script +=
        fmt::format("set arrow from {0:.9g}, graph 0 to {0:.9g}, graph 1 nohead back {1}\n", curve.cuts[i], cut_style);
  script += fmt::format("set xrange [{:.9g}:{:.9g}]\n", curve.begin(), curve.end());
  script +=
      "set size 1,0.66\nset origin 0,0.34\nset bmargin 1\nset tmargin 4\nset format x ''\nset offsets 0,0,graph "
      "0.04,graph 0.04\n";
  script += "set title " + quoted(plot.title) + "\nset ylabel " + quoted(plot.quantity) + "\n";
  script += "set key outside top right horizontal samplen 2\n";
  const double dot = plot.times.size() > 500 ? 0.35 : 0.7;
  script += fmt::format(
      "plot $samples with points pt 7 ps {} lc rgb '#7a8794' title 'samples', $curve with lines lw 2 lc rgb '#1f4e9c' "
      "title 'fitted curve'{}\n",
      dot, curve.segments() > 1 ? fmt::format(", NaN with lines {} title 'cuts'", cut_style) : "");
  script +=
      "unset title\nunset key\nset size 1,0.34\nset origin 0,0\nset bmargin 3.4\nset tmargin 0.6\nset format x '%g'\n";
  script += "set xlabel 'time (s)'\nset ylabel " + quoted("residual (" + plot.unit + ")") + "\n";
  script += "set yzeroaxis\nset xzeroaxis lc rgb '#888888'\n";
  script += fmt::format("plot $residual with points pt 7 ps {} lc rgb '#7a8794'\nunset multiplot\n", dot);
  return script;
}

/// gnuplot's exit code; -1 where it is not there.
int run_gnuplot(const std::string& script) {
  std::string program = "gnuplot", option = "-";
  int ends[2];
  if (::pipe(ends) != 0) return -1;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], 0);
  posix_spawn_file_actions_addclose(&actions, ends[1]);
  char* words[] = {program.data(), option.data(), nullptr};
  pid_t child = -1;
  const int failed = posix_spawnp(&child, words[0], &actions, nullptr, words, environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[0]);
  if (failed != 0) {
    ::close(ends[1]);
    return -1;
  }
  for (std::size_t sent = 0; sent < script.size();) {
    const ssize_t n = ::write(ends[1], script.data() + sent, script.size() - sent);
    if (n <= 0) break;
    sent += static_cast<std::size_t>(n);
  }
  ::close(ends[1]);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? (WEXITSTATUS(status) == 127 ? -1 : WEXITSTATUS(status)) : 1;
}

}  // namespace

Result<void> plot_curve(const CurvePlot& plot, const fs::path& output) {
  const std::string extension = lower(output.extension().string());
  if (extension != ".svg" && extension != ".png")
    return failure(ErrorKind::usage, "-o {}: expected a name that ends in .svg or .png", output.string());
  if (auto ok = check_writable(output); !ok) return ok;
  auto drawn = TemporaryFile::create(output);
  if (!drawn) return pass_on(std::move(drawn));
  const int code = run_gnuplot(script_of(plot, extension == ".svg" ? "svg" : "pngcairo", drawn->path()));
  if (code < 0)
    return failure(ErrorKind::cannot_write,
                   "{}: plots are drawn by gnuplot, which is not installed; "
                   "`apt-get install gnuplot-nox` installs it",
                   output.string());
  std::error_code error;
  if (code != 0 || fs::file_size(drawn->path(), error) == 0)
    return failure(ErrorKind::cannot_write, "{}: gnuplot failed with exit code {}", output.string(), code);
  return drawn->appear();
}

}  // namespace sinew
