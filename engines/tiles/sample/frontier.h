#pragma once
#include <span>
#include <vector>

#include "base/random.h"
#include "engines/tiles/sample/window_plan.h"

namespace solitaire::tiles {

/// Redraws windows of a map from their exact distribution given the rest of the map: forward, the weight of
/// all ways to fill the sites so far is summed up by what later factors can still see of them (the frontier);
/// backward, one of the ways is drawn (forward filtering, backward sampling; the factors are those of Yeh et
/// al. 2012, who do not have this sampler).
class Frontier {
 public:
  explicit Frontier(const Problem& problem) : plan_(problem), tile_bits_(bits_of(problem)) {}

  /// Redraws the sites: in two halves, one after the other, where all together would take more than
  /// kMostStates different frontiers. Whether they would depends on the tiles around the window, never on
  /// those in it, so that each half is drawn from its exact distribution, too. Returns how many sites are
  /// left as they were, since even one of them alone would take too many.
  std::size_t redraw(Grid& map, std::span<const std::uint32_t> sites, Weights& weights, RandomStream& random);

  static constexpr std::size_t kMostStates = 20'000;

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  struct State {
    FrontierKey key;
    double weight;                // of all ways that lead here
    std::uint32_t edges = kNone;  // the last of them
  };
  /// One way from a state before a step to a state after it.
  struct Edge {
    std::uint32_t from;  // the state before
    std::uint32_t next;  // another edge to the same state
    double weight;
    Tile tile;
  };

  static unsigned bits_of(const Problem& problem);
  bool sum_up();
  void advance(const PlanStep& step, std::uint32_t from, std::size_t first);
  void find_weights(const PlanStep& step, FrontierKey key);
  std::uint32_t state_of(FrontierKey key, std::size_t first);
  std::uint32_t state_at(std::uint32_t& entry, FrontierKey key);
  void normalize(std::size_t first);
  void draw_back(Grid& map, RandomStream& random) const;
  Tile tile_in(FrontierKey key, unsigned slot) const {
    return static_cast<Tile>((key >> slot) & ((1U << tile_bits_) - 1));
  }

  WindowPlan plan_;
  unsigned tile_bits_;
  std::vector<double> weights_;  // by tile: the product of the step's factors, for the state at work
  std::vector<State> states_;    // of all steps, one after another
  std::vector<Edge> edges_;
  // Of the states after the present step: by key where direct_, else by hash.
  std::vector<std::uint32_t> table_;
  bool direct_ = false;
};

}  // namespace solitaire::tiles
