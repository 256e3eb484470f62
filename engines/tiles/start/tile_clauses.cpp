#include "engines/tiles/start/tile_clauses.h"

#include <stdexcept>

namespace solitaire::tiles {
namespace {

/// Up to so many variables, pairs say that at most one of them holds.
constexpr std::size_t kMostByPairs = 8;

}  // namespace

TileClauses::TileClauses(const Block& block, CaDiCaL::Solver& solver) : block_(block), solver_(solver) {
  first_.reserve(block.size());
  for (std::size_t place = 0; place < block.size(); ++place) {
    first_.push_back(last_ + 1);
    last_ += static_cast<int>(block.domain(place).size());
  }
}

int TileClauses::variable(std::size_t place, Tile tile) const {
  return first_[place] + static_cast<int>((block_.domain(place) & TileMask::first(tile)).size());
}

void TileClauses::clause(const std::vector<int>& literals) {
  for (const int literal : literals) solver_.add(literal);
  solver_.add(0);
}

bool TileClauses::add_all(const StopSignal& stop) {
  for (std::size_t place = 0; place < block_.size(); ++place) {
    if (place % 256 == 0 && stop.stopped()) return false;
    add_choice(place);
    add_pairs(place);
  }
  return true;
}

void TileClauses::add_choice(std::size_t place) {
  std::vector<int> variables;
  block_.domain(place).for_each([&](Tile tile) { variables.push_back(variable(place, tile)); });
  clause(variables);
  at_most_one(variables);
}

/// By pairs where there are few, else a ladder: `before` holds if one of those up to here does (Sinz 2005).
void TileClauses::at_most_one(const std::vector<int>& variables) {
  if (variables.size() <= kMostByPairs) {
    for (std::size_t b = 1; b < variables.size(); ++b) {
      for (std::size_t a = 0; a < b; ++a) clause({-variables[a], -variables[b]});
    }
    return;
  }
  int before = variables.front();
  for (std::size_t i = 1; i < variables.size(); ++i) {
    clause({-before, -variables[i]});
    const int now = new_variable();
    clause({-before, now});
    clause({-variables[i], now});
    before = now;
  }
}

void TileClauses::add_pairs(std::size_t place) {
  const TileMask& tiles = block_.domain(place);
  block_.for_each_neighbor(place, [&](std::size_t neighbor, std::size_t axis, int step) {
    const PairRules& pairs = block_.problem().pairs(block_.zone(place), block_.zone(neighbor));
    const TileMask& others = block_.domain(neighbor);
    tiles.for_each([&](Tile tile) {
      const TileMask partners = others & pairs.beside(tile, axis, step);
      if (partners == others) return;
      std::vector<int> support{-variable(place, tile)};
      partners.for_each([&](Tile partner) { support.push_back(variable(neighbor, partner)); });
      clause(support);
    });
  });
}

Tile TileClauses::tile(std::size_t place) const {
  Tile result = kHole;
  block_.domain(place).for_each([&](Tile tile) {
    if (solver_.val(variable(place, tile)) > 0) result = tile;
  });
  if (result == kHole) throw std::logic_error("the solver's model has a place without a tile");
  return result;
}

}  // namespace solitaire::tiles
