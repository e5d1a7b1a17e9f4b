#pragma once
/// What `fit-skin` says of a fit.

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "engine/fit/shape_fit.h"

namespace sinew::tools {

/// `tested`: poses were held back to test the fit in; else `test_rmse` is null.
nlohmann::ordered_json fit_report_json(const std::string& file, std::string_view method, const FitReport& report,
                                       bool tested);
void print_fit_report(const std::string& file, const FitReport& report, bool tested);

}  // namespace sinew::tools
