#include "bench/tiles/figures.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "bench/tiles/problems.h"
#include "bench/tiles/runs.h"
#include "bench/tiles/texture.h"
#include "engines/tiles/learn/fit.h"
#include "engines/tiles/learn/patterns.h"

namespace solitaire::tiles::bench {
namespace {

constexpr double kEpsilon = 0.1;
constexpr int kSide = 20;
const std::vector<Size> kFours{{{4, 1, 1}}, {{1, 4, 1}}};

std::shared_ptr<Style> soft_facade(double epsilon = kEpsilon) { return step_style(kFacade, kFours, epsilon); }

/// Returns how many patches of a map some exemplar has, as the logarithm of what they multiply.
double score(const Style& style, const Grid& map) {
  double known = 0;
  for (const SoftShape& shape : style.shapes) {
    const PatchCounts counts = count_patches(map, {map.size, {}}, shape.patches);
    known += counts.total - counts.count[0];
  }
  return known * std::log1p(kEpsilon);
}

/// Draws facades in an L by a sampler, and returns their divergence.
double l_divergence(Report& report, const std::string& name, const std::shared_ptr<const Style>& style,
                    const SamplerOptions& options) {
  const Runs runs = run(facade_in_l(style, kSide), options, 10, 20);
  const double divergence = divergence_of_fours(*style, runs.maps);
  report.line(fmt::format("{:22} KL {:.2f}, JS {:.3f}, {} of {} maps, {:.3f} s each", name, divergence,
                          shannon_of_fours(*style, runs.maps), runs.maps.size(), runs.tried,
                          runs.seconds_each()));
  return divergence;
}

}  // namespace

void texture_synthesis(Report& report) {
  report.figure("figure 7: texture synthesis leaves seams", "shown");
  const auto style = style_named(kFacade);
  std::size_t least = SIZE_MAX, most = 0;
  for (std::uint64_t number = 0; number < 5; ++number) {
    RandomStream random(number, Purpose::kTiles, 0);
    const std::size_t broken = broken_pairs(*style, synthesize_texture(*style, {{kSide, kSide, 1}}, random));
    least = std::min(least, broken);
    most = std::max(most, broken);
  }
  report.line(fmt::format("{} to {} of 760 pairs are broken; windows and BlockSS have none", least, most));
  report.must("texture synthesis breaks pairs", most > 0);
}

void facades_in_an_l(Report& report) {
  report.figure("figures 8 and 9: facades of 20x20 in an L, divergence from the exemplar",
                "CSP .907, BlockSS with hard factors .651, with soft ones .528");
  const auto hard = style_named(kFacade), soft = soft_facade(), fitted = style_named(kFacade);
  std::vector<Size> shapes = default_shapes(*fitted);
  shapes.insert(shapes.end(), kFours.begin(), kFours.end());
  fit_weights(*fitted, shapes, 1, StopSignal());
  const double raster = l_divergence(report, "model synthesis", hard, options_of(SamplerKind::kRaster));
  l_divergence(report, "SAT alone", hard, options_of(SamplerKind::kSearch));
  l_divergence(report, "WaveFunctionCollapse", hard, options_of(SamplerKind::kWfc));
  const double blocks = l_divergence(report, "BlockSS, hard", hard, options_of(SamplerKind::kBlockSs));
  const double soft_blocks =
      l_divergence(report, "BlockSS, soft", soft, options_of(SamplerKind::kBlockSs, 5));
  const double windows = l_divergence(report, "windows, epsilon .1", soft, options_of(SamplerKind::kWindows));
  const double best = l_divergence(report, "windows, fitted", fitted, options_of(SamplerKind::kWindows));
  report.must("CSP > BlockSS hard > BlockSS soft", raster > blocks && blocks > soft_blocks);
  report.must("fitted windows are nearest", best < std::min(soft_blocks, windows));
}

void burn_in(Report& report) {
  report.figure("figure 10: the score of a chain's samples levels off by the fifth", "yes (115 runs)");
  const auto style = soft_facade();
  const Problem problem = facade_in_l(style, kSide);
  std::vector<double> means;
  std::string text;
  for (std::uint64_t each = 0; each < 9; ++each) {
    const Runs runs = run(problem, options_of(SamplerKind::kBlockSs, each), 20);
    double sum = 0;
    for (const Grid& map : runs.maps) sum += score(*style, map);
    means.push_back(sum / static_cast<double>(runs.maps.size()));
    text += fmt::format(" {:.1f}", means.back());
  }
  report.line("mean scores of samples 0 to 8 (20 runs):" + text);
  report.must("less than 1 is gained after the fifth", means[8] - means[5] < 1);
}

void single_sites(Report& report) {
  report.figure("figure 11: single-site sampling against BlockSS",
                "BlockSS 90 times as fast at 100 tiles, 7000 at 900; 1600 tiles: 2 min against never");
  const auto style = style_named(kStoreys);
  bool holds = true;
  for (const int side : {10, 20, 30}) {
    const Problem problem = facade(style, side, side);
    const Runs blocks = run(problem, options_of(SamplerKind::kBlockSs), 5);
    const double limit = std::clamp(100 * blocks.seconds_each(), 1.0, 20.0);
    SamplerOptions mh = options_of(SamplerKind::kMh), gibbs = options_of(SamplerKind::kGibbs);
    mh.effort = gibbs.effort = UINT64_MAX;
    const Runs by_mh = run(problem, mh, 2, limit), by_gibbs = run(problem, gibbs, 2, limit);
    report.line(fmt::format("{0}x{0}: BlockSS {1:.3f} s; within {2:.0f} s: MH {3} of 2, Gibbs {4} of 2", side,
                            blocks.seconds_each(), limit, by_mh.maps.size(), by_gibbs.maps.size()));
    if (side >= 20) holds = holds && by_mh.maps.empty();
  }
  report.must("from 20x20 on MH takes more than a hundred times as long, or 20 s", holds);
}

void sizes_of_blocks(Report& report) {
  report.figure("figure 12: larger blocks are faster", "yes");
  const auto style = style_named(kStoreys);
  std::vector<double> seconds;
  std::string text;
  for (int blocks = 1; blocks <= 6; ++blocks) {
    const Runs runs = run(facade(style, kSide, kSide), options_of(SamplerKind::kBlockSs, 0, blocks), 10, 20);
    seconds.push_back(runs.seconds_each());
    text += fmt::format(" B{} {:.3f} s", blocks, seconds.back());
  }
  report.line("facades of 20x20:" + text);
  report.must("B6 is at least three times as fast as B1", seconds[0] > 3 * seconds[5]);
}

void growing_cities(Report& report) {
  report.figure("figure 13, left: cities with a crossroad every 20 tiles are linear in the area",
                "yes; 170x170 in 5 min");
  const auto hard = style_named(kSuburb), soft = step_style(kSuburb, {{{2, 2, 1}}, {{4, 4, 1}}}, kEpsilon);
  std::vector<double> rates;
  double last = 0;
  for (const int side : {20, 60, 85, 120, 170}) {
    const Runs plain = run(city(hard, side), options_of(SamplerKind::kBlockSs), 3);
    last = plain.seconds_each();
    if (side >= 60) rates.push_back(last / side / side);
    const Runs with_soft = run(city(soft, side), options_of(SamplerKind::kBlockSs), 1);
    report.line(
        fmt::format("{0}x{0}: {1:.3f} s, with 2x2 and 4x4 {2:.3f} s", side, last, with_soft.seconds_each()));
  }
  const auto [least, most] = std::ranges::minmax(rates);
  report.must("linear from 60x60 on, within a quarter around the mean", most < 1.67 * least);
  report.must("170x170 in 1.5 s", last < 1.5);
}

void growing_facades(Report& report) {
  report.figure("figure 13, right: facades get harder faster than they grow", "yes");
  const auto style = style_named(kStoreys);
  std::vector<double> seconds;
  std::string text;
  for (const int side : {10, 20, 30, 40}) {
    seconds.push_back(run(facade(style, side, side), options_of(SamplerKind::kBlockSs), 5).seconds_each());
    text += fmt::format(" {0}x{0} {1:.3f} s", side, seconds.back());
  }
  report.line(text.substr(1));
  report.must("16 times the area takes more than 16 times as long", seconds[3] > 16 * seconds[0]);
}

void growing_epsilon(Report& report) {
  report.figure("table I: a larger epsilon comes nearer to the exemplar and takes longer",
                "its rows stand behind ours; its times vary by twice their mean");
  struct Row {
    double epsilon, divergence, seconds;  // as the paper has them
  };
  const Row rows[] = {{.05, .587, 63}, {.1, .481, 77},   {.2, .449, 472}, {.3, .453, 237},
                      {.4, .389, 419}, {.5, .358, 1445}, {.6, .301, 453}};
  std::map<double, double> divergences;
  for (const Row& row : rows) {
    const auto style = soft_facade(row.epsilon);
    const Runs runs = run(facade_in_l(style, kSide), options_of(SamplerKind::kBlockSs, 5), 10);
    divergences[row.epsilon] = divergence_of_fours(*style, runs.maps);
    report.line(fmt::format("epsilon {:.2f}: KL {:.2f}, {:.3f} s a sample (paper: {:.3f}, {:.0f} s)",
                            row.epsilon, divergences[row.epsilon], runs.seconds_each() / 6, row.divergence,
                            row.seconds));
  }
  report.must("KL falls by .05 at least from .05 to .5", divergences.at(.5) < divergences.at(.05) - .05);
}

}  // namespace solitaire::tiles::bench
