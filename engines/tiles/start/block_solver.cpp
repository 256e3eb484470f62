#include "engines/tiles/start/block_solver.h"

#include <cadical.hpp>

#include "engines/tiles/start/collapse.h"
#include "engines/tiles/start/stop_by_signal.h"
#include "engines/tiles/start/tile_clauses.h"

namespace solitaire::tiles {
namespace {

/// Sets what the solver tries first: for each place one tile, drawn by frequency.
void suggest(const Block& block, const TileClauses& clauses, CaDiCaL::Solver& solver, RandomStream& random) {
  for (std::size_t place = 0; place < block.size(); ++place) {
    const auto& frequencies = block.problem().style().frequencies[block.zone(place)];
    const Tile drawn = draw_tile(block.domain(place), frequencies, random);
    block.domain(place).for_each([&](Tile tile) {
      const int variable = clauses.variable(place, tile);
      solver.phase(tile == drawn ? variable : -variable);
    });
  }
}

}  // namespace

Outcome solve_block(Block& block, RandomStream& random, const StopSignal& stop) {
  if (!block.propagate()) return Outcome::kNone;
  CaDiCaL::Solver solver;
  solver.set("quiet", 1);
  solver.set("lucky", 0);  // would ignore what is suggested
  solver.set("seed", static_cast<int>(random.below(1'000'000'000)));
  TileClauses clauses(block, solver);
  if (!clauses.add_all(stop)) return Outcome::kStopped;
  suggest(block, clauses, solver, random);
  StopBySignal terminator(stop);
  solver.connect_terminator(&terminator);
  const int answer = solver.solve();
  solver.disconnect_terminator();
  if (answer != 10) return answer == 20 ? Outcome::kNone : Outcome::kStopped;
  std::vector<Tile> model;
  for (std::size_t place = 0; place < block.size(); ++place) model.push_back(clauses.tile(place));
  for (std::size_t place = 0; place < block.size(); ++place)
    block.restrict(place, TileMask::of(model[place]));
  return Outcome::kFound;
}

}  // namespace solitaire::tiles
