#pragma once
#include <cadical.hpp>
#include <vector>

#include "base/stop_signal.h"
#include "engines/tiles/start/block.h"

namespace solitaire::tiles {

/// Says in clauses what holds in a block, for CaDiCaL.
class TileClauses {
 public:
  /// Numbers the variables; `block` has been propagated.
  TileClauses(const Block& block, CaDiCaL::Solver& solver);

  /// Returns the variable of a tile in the place's domain.
  int variable(std::size_t place, Tile tile) const;
  int new_variable() { return ++last_; }
  void clause(const std::vector<int>& literals);
  /// Exactly one tile is at each place, and neighbours go together. Returns false if the signal came first.
  bool add_all(const StopSignal& stop);
  /// After a search that found a model: the tile at a place.
  Tile tile(std::size_t place) const;

 private:
  void add_choice(std::size_t place);
  void add_pairs(std::size_t place);
  void at_most_one(const std::vector<int>& variables);

  const Block& block_;
  CaDiCaL::Solver& solver_;
  std::vector<int> first_;  // by place: the variable of its lowest tile
  int last_ = 0;
};

}  // namespace solitaire::tiles
