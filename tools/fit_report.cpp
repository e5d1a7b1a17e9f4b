#include "tools/fit_report.h"

#include <algorithm>
#include <iostream>

#include <fmt/format.h>

namespace sinew::tools {

nlohmann::ordered_json fit_report_json(const std::string& file, std::string_view method, const FitReport& report,
                                       bool tested) {
  nlohmann::ordered_json json{{"file", file},
                              {"method", method},
                              {"vertices", report.vertices},
                              {"poses", report.poses},
                              {"bones", report.bones},
                              {"max_influences", report.max_influences},
                              {"rmse", report.rmse},
                              {"max_error", report.max_error},
                              {"relative_rmse", report.diagonal > 0.0 ? report.rmse / report.diagonal : 0.0},
                              {"test_rmse", nullptr},
                              {"ms", report.milliseconds},
                              {"height", report.height},
                              {"noise", report.noise},
                              {"negative_vertices", report.negative},
                              {"undetermined_vertices", report.undetermined}};
  if (tested) json["test_rmse"] = report.test_rmse;
  json["worst"] = nlohmann::ordered_json::array();
  for (const WorstVertex& worst : report.worst)
    json["worst"].push_back({{"vertex", worst.vertex}, {"mesh", worst.mesh}, {"rmse", worst.rmse}});
  json["shells"] = nlohmann::ordered_json::array();
  for (const ShellResidual& shell : report.shells)
    json["shells"].push_back({{"mesh", shell.mesh}, {"vertices", shell.vertices}, {"rmse", shell.rmse}});
  json["reasons"] = report.reasons;
  return json;
}

void print_fit_report(const std::string& file, const FitReport& report, bool tested) {
  std::cout << fmt::format("{}: {} vertices, {} bones, {} poses, at most {} influences, {:.0f} ms\n", file,
                           report.vertices, report.bones, report.poses, report.max_influences, report.milliseconds);
  std::cout << fmt::format("RMSE {:.3g} ({:.3g} of the box), largest error {:.3g}\n", report.rmse,
                           report.diagonal > 0.0 ? report.rmse / report.diagonal : 0.0, report.max_error);
  if (tested) std::cout << fmt::format("RMSE {:.3g} in clean poses that the fit did not see\n", report.test_rmse);
  if (report.negative > 0) std::cout << fmt::format("{} vertices had negative weights, cut to 0\n", report.negative);
  std::cout << "worst vertices:\n";
  for (const WorstVertex& worst : report.worst)
    std::cout << fmt::format("  {:>8}  {:.3g}  {}\n", worst.vertex, worst.rmse, worst.mesh);
  std::cout << "shells:\n";
  constexpr std::size_t shown = 10;
  for (std::size_t i = 0; i < std::min(shown, report.shells.size()); ++i)
    std::cout << fmt::format("  {:>8} vertices  {:.3g}  {}\n", report.shells[i].vertices, report.shells[i].rmse,
                             report.shells[i].mesh);
  if (report.shells.size() > shown) std::cout << fmt::format("  and {} more\n", report.shells.size() - shown);
}

}  // namespace sinew::tools
