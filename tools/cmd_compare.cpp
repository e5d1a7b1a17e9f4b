#include <algorithm>

#include <spdlog/spdlog.h>

#include "engine/core/files.h"
#include "engine/core/text.h"
#include "engine/io/png.h"
#include "engine/render/flip.h"
#include "engine/render/picture_compare.h"
#include "tools/command.h"

namespace sinew::tools {
namespace {

struct Words {
  CommonOptions common;
  std::string a, b, diff, metric = "pixels";
  int tolerance = 0;
  double pixels = 0.0, threshold = 0.01;
};

/// What was found, whichever way the pictures were compared.
struct Verdict {
  double value = 0.0, threshold = 0.0;
  std::string summary;
};

Result<Picture> open_picture(const std::string& file) {
  auto bytes = read_file(file);
  if (!bytes) return pass_on(std::move(bytes));
  auto png = decode_png(*bytes);
  if (!png) return bad_input("{}: {}", file, png.error().message);
  return Picture{png->width, png->height, std::move(png->rgba)};
}

Result<void> write_difference(const Words& words, const Picture& a, const Picture& b) {
  if (words.diff.empty()) return {};
  const Picture difference = difference_picture(a, b);
  auto png = encode_png(difference.rgba, difference.width, difference.height, {}, false);
  if (!png) return pass_on(std::move(png));
  return write_file(words.diff, *png);
}

Result<void> check_words(const Words& words) {
  const std::vector<std::string> metrics{"pixels", "ssim", "flip"};
  if (std::find(metrics.begin(), metrics.end(), words.metric) == metrics.end())
    return failure(ErrorKind::usage, "--metric {}: expected one of {}{}", words.metric, fmt::join(metrics, ", "),
                   did_you_mean(words.metric, metrics));
  if (words.tolerance < 0 || words.tolerance > 255)
    return failure(ErrorKind::usage, "--tolerance {}: expected 0 to 255", words.tolerance);
  if (!(words.pixels >= 0.0 && words.pixels <= 1.0))
    return failure(ErrorKind::usage, "--pixels {}: expected a share from 0 to 1", words.pixels);
  if (!words.diff.empty() && !words.diff.ends_with(".png"))
    return failure(ErrorKind::usage, "--diff {}: expected a name that ends in .png", words.diff);
  if (!(words.threshold >= 0.0))
    return failure(ErrorKind::usage, "--threshold {}: expected a number of 0 or more", words.threshold);
  return {};
}

Result<Verdict> judge(const Words& words, const Picture& a, const Picture& b, const PixelComparison& compared) {
  if (words.metric == "ssim") {
    const auto value = structural_dissimilarity(a, b);
    if (!value) return tl::unexpected<Error>(value.error());
    return Verdict{*value, words.threshold,
                   fmt::format("1 - SSIM is {:.5f}, at most {} may be", *value, words.threshold)};
  }
  if (words.metric == "flip") {
    const auto map = flip(a, b);
    if (!map) return tl::unexpected<Error>(map.error());
    const double value = map->mean();
    return Verdict{value, words.threshold,
                   fmt::format("mean FLIP is {:.5f}, at most {} may be", value, words.threshold)};
  }
  const double share = static_cast<double>(compared.pixels_over) / static_cast<double>(compared.pixels);
  return Verdict{
      share, words.pixels,
      fmt::format("{} of {} pixels differ by more than {} levels (largest {}): a share of {:.4g}, at most {:.4g} may",
                  compared.pixels_over, compared.pixels, words.tolerance, compared.largest_difference, share,
                  words.pixels)};
}

Result<void> compare(const Words& words) {
  apply_verbosity(words.common);
  if (auto ok = check_words(words); !ok) return ok;
  auto a = open_picture(words.a);
  if (!a) return pass_on(std::move(a));
  auto b = open_picture(words.b);
  if (!b) return pass_on(std::move(b));
  auto compared = compare_pixels(*a, *b, words.tolerance);
  if (!compared) return bad_input("{} and {}: {}", words.a, words.b, compared.error().message);
  if (auto ok = write_difference(words, *a, *b); !ok) return ok;
  auto verdict = judge(words, *a, *b, *compared);
  if (!verdict) return pass_on(std::move(verdict));
  const bool pass = verdict->value <= verdict->threshold;
  if (words.common.json)
    print_json({{"metric", words.metric},
                {"value", verdict->value},
                {"threshold", verdict->threshold},
                {"pixels_over", compared->pixels_over},
                {"largest_difference", compared->largest_difference},
                {"pass", pass}});
  if (!pass) return failure(ErrorKind::check_failed, "the pictures differ: {}", verdict->summary);
  spdlog::info("the pictures agree: {}", verdict->summary);
  return {};
}

}  // namespace

void add_compare(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("compare", "Picture difference");
  command->footer("Example: sinew compare a.png b.png --tolerance 3 --pixels 0.001 --diff difference.png");
  auto words = std::make_shared<Words>();
  command->add_option("a", words->a, "A picture (.png)")->required();
  command->add_option("b", words->b, "Another of the same size")->required();
  command->add_option("--tolerance", words->tolerance, "Levels of 255 by which a channel may differ")
      ->capture_default_str();
  command->add_option("--pixels", words->pixels, "Share of the pixels that may exceed it, 0 to 1")
      ->capture_default_str();
  command->add_option("--metric", words->metric, "How to compare: pixels, ssim or flip")->capture_default_str();
  command->add_option("--threshold", words->threshold, "Of 1 - SSIM or the mean FLIP: at most this may it be")
      ->capture_default_str();
  command->add_option("--diff", words->diff, "Write the difference, eight times amplified, to this .png");
  add_common_options(*command, words->common);
  command->callback([words, &run] { run = [words] { return compare(*words); }; });
}

}  // namespace sinew::tools
