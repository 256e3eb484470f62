#include "engines/tiles/learn/fit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/hash.h"
#include "engines/tiles/learn/patterns.h"
#include "engines/tiles/sample/frontier.h"
#include "engines/tiles/sample/sampler_options.h"
#include "engines/tiles/sample/sweep.h"
#include "engines/tiles/start/start.h"

namespace solitaire::tiles {
namespace {

constexpr int kChains = 4;
constexpr int kSteps = 320;
constexpr int kFlatExtent = 40;  // sites of a chain's map along each axis
constexpr int kDeepExtent = 12;  // the same where there are several layers
constexpr double kRate = 0.15;   // of the first steps
constexpr double kSlower = 60;   // steps after which it is half of that
/// From this step on the chains begin anew in turns, each after so many steps: see begin_anew().
constexpr int kFirstAnew = 80, kStepsOfLife = 40;
constexpr double kShrink = 0.0005;
constexpr double kMostWeight = 6;

bool is_deep(const Style& style) {
  return std::ranges::any_of(style.exemplars,
                             [](const Exemplar& each) { return each.grid.size.depth() > 1; });
}

/// The part of a style that belongs to one zone, on its own.
std::shared_ptr<Style> only_zone(const Style& style, std::size_t zone) {
  auto part = std::make_shared<Style>();
  part->tileset = style.tileset;
  for (const Exemplar& exemplar : style.exemplars) {
    if (exemplar.zone != zone) continue;
    part->exemplars.push_back(exemplar);
    part->exemplars.back().zone = 0;
  }
  part->pairs = {style.pairs[zone]};
  part->frequencies = {style.frequencies[zone]};
  return part;
}

/// Returns the topology of the maps by which weights are fitted.
Topology topology_of_chains(const Style& style) {
  if (is_deep(style)) return {{{kDeepExtent, kDeepExtent, kDeepExtent}}, {}};
  Point extent{1, 1, 1};
  for (const Exemplar& exemplar : style.exemplars) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (exemplar.grid.size.extent[axis] > 1) extent[axis] = kFlatExtent;
    }
  }
  return {{extent}, {}};
}

/// Returns the problem of these maps, with further rules where some map keeps them.
Problem problem_of_chains(const std::shared_ptr<Style>& style, std::uint64_t seed, const StopSignal& stop,
                          const std::function<void(Problem&)>& add_rules) {
  const Problem plain(style, topology_of_chains(*style));
  if (!add_rules) return plain;
  Problem ruled = plain;
  add_rules(ruled);
  const std::vector<TileMask> domains = consistent_domains(ruled);
  if (domains.empty()) return plain;
  RandomStream random(seed, Purpose::kTiles, UINT64_MAX);
  Grid map;
  return make_start(ruled, domains, random, stop, map) == Outcome::kNone ? plain : ruled;
}

/// Fits the weights of a style with a single zone.
class Fitting {
 public:
  Fitting(std::shared_ptr<Style> style, const Problem& problem, std::uint64_t seed, const StopSignal& stop)
      : style_(std::move(style)),
        problem_(problem),
        plan_(problem_),
        frontier_(problem_),
        weights_(*style_),
        seed_(seed),
        stop_(stop) {
    for (const SoftShape& shape : style_->shapes) {
      wanted_.push_back(count_patches(*style_, 0, shape.patches));
      mean_.emplace_back(shape.patches.size() + 1);
    }
  }

  void run() {
    start_chains();
    for (int step = 0; step < kSteps; ++step) {
      for (std::size_t chain = 0; chain < chains_.size(); ++chain) {
        if (is_turn_of(chain, step)) begin_anew(chain, step);
        advance(chain, step);
      }
      const double rate = kRate / (1 + step / kSlower);
      for (std::size_t shape = 0; shape < style_->shapes.size(); ++shape) correct(shape, rate, step);
      weights_.set_power(1);
    }
    for (std::size_t shape = 0; shape < mean_.size(); ++shape) {
      for (double& each : mean_[shape]) each /= kSteps / 2;
      style_->shapes[shape].log_weights[0] = mean_[shape];
    }
  }

 private:
  void start_chains() {
    domains_ = consistent_domains(problem_);
    chains_.resize(kChains);
    for (std::size_t chain = 0; chain < kChains; ++chain) {
      RandomStream random(mix(seed_, chain), Purpose::kTiles, UINT64_MAX);
      const Outcome outcome = make_start(problem_, domains_, random, stop_, chains_[chain]);
      if (outcome == Outcome::kStopped) throw Interrupted();
      if (outcome == Outcome::kNone) {
        throw std::runtime_error(
            "the weights cannot be fitted: the exemplar's tiles fit no large map, as some occur at its "
            "border "
            "only; say --weights step, or let the exemplar be periodic");
      }
    }
  }

  static bool is_turn_of(std::size_t chain, int step) {
    const int turn = static_cast<int>(chain) * kStepsOfLife / kChains;
    return step >= kFirstAnew && step % kStepsOfLife == turn;
  }

  /// Begins a chain with a new map, made as maps are: from a start, by weights that grow to their strength.
  /// What windows hardly change, such as a street that crosses the map, is then as frequent as in new maps,
  /// and the weights make up for it. Chains that go on for ever would suit themselves only.
  void begin_anew(std::size_t chain, int step) {
    RandomStream random(mix(seed_, chain), Purpose::kTiles,
                        mix(UINT64_MAX, static_cast<std::uint64_t>(step)));
    if (make_start(problem_, domains_, random, stop_, chains_[chain]) != Outcome::kFound) throw Interrupted();
    const int sweeps = static_cast<int>(SamplerOptions().anneal);
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      weights_.set_power(static_cast<double>(sweep + 1) / (sweeps + 1));
      redraw_bands(chain, static_cast<std::uint64_t>(sweep), random);
    }
    weights_.set_power(1);
  }

  void redraw_bands(std::size_t chain, std::uint64_t sweep, RandomStream& random) {
    for (const auto& window : plan_.bands(sweep, random)) {
      frontier_.redraw(chains_[chain], window, weights_, random);
    }
    if (stop_.stopped()) throw Interrupted();
  }

  /// Lets a chain redraw its rows and its columns. Thick bands are among them: with thin ones alone, the
  /// chains stay for long near where they started, and the weights then suit these maps only.
  void advance(std::size_t chain, int step) {
    for (std::uint64_t turn = 0; turn < 2; ++turn) {
      const std::uint64_t sweep = 2 * static_cast<std::uint64_t>(step) + turn;
      RandomStream random(mix(seed_, chain), Purpose::kTiles, sweep);
      redraw_bands(chain, sweep, random);
    }
  }

  /// Changes the weights of a shape's patches towards those that occur too seldom.
  void correct(std::size_t shape, double rate, int step) {
    SoftShape& soft = style_->shapes[shape];
    PatchCounts found{std::vector<double>(soft.patches.size() + 1), 0};
    for (const Grid& map : chains_) {
      const PatchCounts counts = count_patches(map, problem_.topology(), soft.patches);
      for (std::size_t number = 0; number < found.count.size(); ++number) {
        found.count[number] += counts.count[number];
      }
      found.total += counts.total;
    }
    if (wanted_[shape].total == 0) return;
    const double least = 0.5 / wanted_[shape].total;
    std::vector<double>& weights = soft.log_weights[0];
    for (std::size_t number = 0; number < weights.size(); ++number) {
      const double goal = std::log(wanted_[shape].count[number] / wanted_[shape].total + least);
      const double now = std::log(found.count[number] / std::max(1.0, found.total) + least);
      weights[number] += rate * (goal - now) - kShrink * rate * weights[number];
      weights[number] = std::clamp(weights[number], -kMostWeight, kMostWeight);
      if (step >= kSteps - kSteps / 2) mean_[shape][number] += weights[number];
    }
  }

  std::shared_ptr<Style> style_;
  Problem problem_;
  SweepPlan plan_;
  Frontier frontier_;
  Weights weights_;
  std::uint64_t seed_;
  const StopSignal& stop_;
  std::vector<PatchCounts> wanted_;        // by shape
  std::vector<std::vector<double>> mean_;  // of the weights, by shape
  std::vector<TileMask> domains_;
  std::vector<Grid> chains_;
};

}  // namespace

std::vector<Size> default_shapes(const Style& style) {
  Point most{1, 1, 1};
  for (const Exemplar& exemplar : style.exemplars) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      most[axis] = std::max(most[axis], std::min(2, exemplar.grid.size.extent[axis]));
    }
  }
  std::vector<Size> shapes;
  for (int z = 1; z <= most[2]; ++z) {
    for (int y = 1; y <= most[1]; ++y) {
      for (int x = 1; x <= most[0]; ++x) {
        if (x * y * z <= 4) shapes.push_back({{x, y, z}});
      }
    }
  }
  return shapes;
}

void fit_weights(Style& style, std::span<const Size> shapes, std::uint64_t seed, const StopSignal& stop,
                 const std::function<void(Problem&)>& add_rules) {
  for (const Size& shape : shapes) add_step_shape(style, shape, 0);
  for (std::size_t zone = 0; zone < style.zones; ++zone) {
    const std::shared_ptr<Style> part = only_zone(style, zone);
    // The patches have the numbers that they have in the whole style.
    for (const SoftShape& shape : style.shapes) {
      part->shapes.push_back({shape.patches, {std::vector<double>(shape.patches.size() + 1)}});
    }
    const std::uint64_t own = mix(seed, zone);
    const auto rules = style.zones == 1 ? add_rules : nullptr;
    Fitting(part, problem_of_chains(part, own, stop, rules), own, stop).run();
    for (std::size_t shape = 0; shape < style.shapes.size(); ++shape) {
      style.shapes[shape].log_weights[zone] = part->shapes[shape].log_weights[0];
    }
  }
}

}  // namespace solitaire::tiles
