#include "bench/tiles/figures.h"
#include "bench/tiles/problems.h"
#include "bench/tiles/runs.h"
#include "engines/tiles/learn/fit.h"
#include "engines/tiles/request/build.h"
#include "engines/tiles/request/read_style.h"
#include "engines/tiles/request/request_file.h"
#include "engines/tiles/sample/refill.h"

namespace solitaire::tiles::bench {
namespace {

std::shared_ptr<Style> fitted_suburb() {
  const auto style = style_named(kSuburb);
  fit_weights(*style, default_shapes(*style), 1, StopSignal());
  return style;
}

void connected_dungeon(Report& report) {
  const Request request = read_request(SOLITAIRE_SOURCE_DIR "/examples/tiles/dungeon.tiles.json");
  const std::shared_ptr<Style> style = read_style(request);
  fit_weights(*style, default_shapes(*style), 1, StopSignal());
  const Runs runs = run(make_problem(request, style), SamplerOptions(), 4);
  report.must(fmt::format("connected dungeons of 40x40: {} of 4, {:.1f} s each, 3 asked", runs.maps.size(),
                          runs.seconds_each()),
              runs.maps.size() == 4 && runs.seconds_each() <= 3);
}

void small_facade(Report& report) {
  const auto style = step_style(kFacade, {{{4, 1, 1}}, {{1, 4, 1}}}, 0.1);
  const Runs runs = run(facade(style, 20, 20), SamplerOptions(), 10);
  report.must(
      fmt::format("facades of 20x20, annealed: {:.0f} ms each, 150 asked", 1000 * runs.seconds_each()),
      runs.seconds_each() <= 0.15);
}

void peer(Report& report, const std::string& name, const Problem& problem, const SamplerOptions& options,
          std::size_t maps) {
  const Runs runs = run(problem, options, maps, 20);
  const std::string likeness =
      runs.maps.empty() ? "" : fmt::format(", JS {:.2f}", shannon_of_fours(problem.style(), runs.maps));
  report.line(fmt::format("{0}x{0} {1:20} {2} of {3} maps, {4:.2f} s for each attempt{5}",
                          problem.size().width(), name, runs.maps.size(), runs.tried, runs.seconds_each(),
                          likeness));
}

}  // namespace

void peers(Report& report) {
  report.figure("peers: cities with a crossroad every 20 tiles; an attempt ends after 20 s",
                "does not have this");
  const auto hard = style_named(kSuburb), fitted = fitted_suburb();
  SamplerOptions once = options_of(SamplerKind::kWfc);
  once.effort = 1;
  SamplerOptions start = options_of(SamplerKind::kWindows);
  start.anneal = start.sweeps = 0;
  for (const int side : {40, 85, 170, 340, 1000}) {
    const std::size_t maps = side <= 85 ? 20 : side <= 170 ? 5 : 1;
    peer(report, "WFC, one attempt", city(hard, side), once, maps);
    peer(report, "start alone", city(hard, side), start, maps);
    if (side <= 170) peer(report, "SAT alone", city(hard, side), options_of(SamplerKind::kSearch), 1);
    if (side <= 340)
      peer(report, "windows, fitted", city(fitted, side), options_of(SamplerKind::kWindows), 1);
  }
}

void speed(Report& report) {
  report.figure("speed: cities by windows with fitted weights", "170x170 in 5 min, without weights");
  double start = processor_seconds();
  const auto style = fitted_suburb();
  const double fitting = processor_seconds() - start;
  report.must(fmt::format("the weights are fitted in {:.1f} s, 6 asked", fitting), fitting <= 6);
  const Runs runs = run(city(style, 170), options_of(SamplerKind::kWindows), 1);
  report.must(fmt::format("170x170 in {:.1f} s, 3 asked", runs.seconds), runs.seconds <= 3);
  connected_dungeon(report);
  small_facade(report);
}

void filling_again(Report& report) {
  report.figure("a part of 40x40 of a city of 170x170 is filled again", "does not have this");
  const Problem problem = city(fitted_suburb(), 170);
  SamplerOptions options;
  options.anneal = 30;
  options.sweeps = 20;
  Grid map = run(problem, options, 1).maps.front();
  constexpr int kTimes = 10;
  const double start = processor_seconds();
  bool all = true;
  for (options.seed = 1; options.seed <= kTimes; ++options.seed) {
    const Box box{{60, 60, 0}, {100, 100, 1}};
    all = refill(problem, box, options, StopSignal(), map) == Outcome::kFound && all;
  }
  const double each = (processor_seconds() - start) / kTimes;
  report.line(fmt::format("{:.0f} ms, {} sweeps", 1000 * each, options.anneal + options.sweeps));
  report.must(fmt::format("40x40 of 170x170 again in {:.0f} ms, 100 asked", 1000 * each), all && each < 0.1);
}

}  // namespace solitaire::tiles::bench
