#pragma once
/// A fitted curve and its samples as a picture, drawn by gnuplot.

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/result.h"
#include "engine/motion/piecewise_polynomial.h"

namespace sinew {

struct CurvePlot {
  std::string title;
  std::string quantity;               ///< of the y axis, with its unit
  std::string unit;                   ///< of the residual
  std::vector<double> times, values;  ///< [samples] seconds
  PiecewisePolynomial curve;
  int width = 1000, height = 700;  ///< pixels
};

/// Writes `.svg` or `.png`: samples as dots, the curve, its cuts as lines, and the residual below. Fails as usage for
/// another extension, as cannot_write where gnuplot is missing or fails, or the file cannot be written.
Result<void> plot_curve(const CurvePlot& plot, const std::filesystem::path& output);

}  // namespace sinew
