#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "base/hash.h"
#include "engines/tiles/model/uniform.h"
#include "engines/tiles/sample/frontier.h"
#include "engines/tiles/sample/sampler.h"
#include "engines/tiles/sample/sweep.h"

namespace solitaire::tiles {
namespace {

constexpr int kBoxLength = 8, kBoxHeight = 6;      // of windows where global rules are looked at
constexpr int kSmallLength = 3, kSmallHeight = 2;  // of further ones, while rules are broken
constexpr std::uint64_t kSmallWindows = std::uint64_t{1} << 40U;  // their numbers begin here
constexpr double kPull = 1.5;        // how much a window that mends a global rule is favoured,
constexpr double kPullGrowth = 0.1;  // and by which share of that more with each sweep after the annealing
constexpr std::uint64_t kMostMending = 400;  // sweeps that are added until the rules hold

/// Makes one map.
class WindowSampling {
 public:
  WindowSampling(const Problem& problem, const std::vector<TileMask>& domains, const SamplerOptions& options,
                 std::uint64_t number, const StopSignal& stop)
      : problem_(problem),
        domains_(domains),
        options_(options),
        key_(mix(options.seed, number)),
        stop_(stop),
        plan_(problem),
        frontier_(problem),
        weights_(problem.style()),
        height_(plan_.affordable_height(kBoxHeight)) {}

  void run(Sample& sample) {
    sample_ = &sample;
    violation_ = problem_.violation(sample.map);
    for (const auto& rule : problem_.global_rules()) watches_.push_back(rule->watch(sample.map));
    const std::uint64_t mending = options_.effort > 0 ? options_.effort : kMostMending;
    const std::uint64_t planned = options_.anneal + options_.sweeps;
    while (sample.sweeps < planned || (violation_ > 0 && sample.sweeps < planned + mending)) {
      if (stop_.stopped()) {
        sample.outcome = Outcome::kStopped;
        return;
      }
      const double done = static_cast<double>(sample.sweeps + 1) / static_cast<double>(options_.anneal + 1);
      weights_.set_power(std::min(1.0, done));
      sweep();
      ++sample.sweeps;
    }
    if (violation_ > 0) sample.outcome = Outcome::kGaveUp;
  }

 private:
  void sweep() {
    const std::uint64_t sweep = sample_->sweeps;
    RandomStream cuts(key_, Purpose::kTiles, mix(sweep, UINT64_MAX));
    if (problem_.global_rules().empty()) {
      redraw_all(plan_.bands(sweep, cuts), 0);
      return;
    }
    redraw_all(plan_.boxes(kBoxLength, height_, sweep, cuts), 0);
    // Small windows mend what large ones hardly ever do, since they change less that is in order.
    if (violation_ > 0) redraw_all(plan_.boxes(kSmallLength, kSmallHeight, sweep, cuts), kSmallWindows);
  }

  /// Redraws windows, whose random numbers are those of the sweep from `first` on.
  void redraw_all(SweepPlan::Windows windows, std::uint64_t first) {
    const bool global = !problem_.global_rules().empty();
    for (std::uint64_t number = 0; number < windows.size(); ++number) {
      if (stop_.stopped()) return;
      leave_out_fixed(windows[number]);
      if (windows[number].empty()) continue;
      RandomStream random(key_, Purpose::kTiles, mix(sample_->sweeps, first + number));
      ++sample_->windows;
      global ? redraw_under_rules(windows[number], random) : redraw(windows[number], random);
    }
  }

  /// Takes the sites out of a window that have the same tile in all maps.
  void leave_out_fixed(std::vector<std::uint32_t>& sites) const {
    std::erase_if(sites, [this](std::uint32_t site) { return domains_[site].size() == 1; });
  }

  void redraw(std::span<const std::uint32_t> sites, RandomStream& random) {
    sample_->left += frontier_.redraw(sample_->map, sites, weights_, random);
  }

  /// Puts the window back if it breaks a rule that held.
  void redraw_under_rules(const std::vector<std::uint32_t>& sites, RandomStream& random) {
    Grid& map = sample_->map;
    before_.clear();
    for (const std::uint32_t site : sites) before_.push_back(map[site]);
    redraw(sites, random);
    std::uint64_t violation = 0;
    for (const auto& watch : watches_) violation += watch->after(map, {sites, before_});
    if (accept(violation, random)) {
      violation_ = violation;
      for (const auto& watch : watches_) watch->keep();
      return;
    }
    ++sample_->refused;
    for (std::size_t place = 0; place < sites.size(); ++place) map[sites[place]] = before_[place];
  }

  bool accept(std::uint64_t violation, RandomStream& random) const {
    if (violation <= violation_) return true;
    if (violation_ == 0) return false;
    return uniform(random) < std::exp(-pull() * static_cast<double>(violation - violation_));
  }

  /// The larger a map is, the more faults come while others go. They have to become rarer for all to be gone
  /// at some time.
  double pull() const {
    const std::uint64_t late = sample_->sweeps - std::min(sample_->sweeps, options_.anneal);
    return kPull * (1 + kPullGrowth * static_cast<double>(late));
  }

  const Problem& problem_;
  const std::vector<TileMask>& domains_;
  const SamplerOptions& options_;
  std::uint64_t key_;
  const StopSignal& stop_;
  SweepPlan plan_;
  Frontier frontier_;
  Weights weights_;
  Sample* sample_ = nullptr;
  std::uint64_t violation_ = 0;  // of all rules
  std::vector<std::unique_ptr<RuleWatch>> watches_;
  std::vector<Tile> before_;
  int height_;  // of boxes
};

}  // namespace

Sample redraw_map(const Problem& problem, const std::vector<TileMask>& domains, const SamplerOptions& options,
                  std::uint64_t number, const StopSignal& stop, const Grid& start) {
  Sample sample;
  sample.map = start;
  sample.outcome = Outcome::kFound;
  WindowSampling(problem, domains, options, number, stop).run(sample);
  return sample;
}

Sample sample_windows(const Problem& problem, const std::vector<TileMask>& domains,
                      const SamplerOptions& options, std::uint64_t number, const StopSignal& stop) {
  Sample sample;
  RandomStream random(mix(options.seed, number), Purpose::kTiles, UINT64_MAX);
  sample.outcome = make_start(problem, domains, random, stop, sample.map);
  if (sample.outcome == Outcome::kFound) WindowSampling(problem, domains, options, number, stop).run(sample);
  return sample;
}

}  // namespace solitaire::tiles
