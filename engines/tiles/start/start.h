#pragma once
#include "base/random.h"
#include "engines/tiles/start/block_solver.h"

namespace solitaire::tiles {

/// Leaves to each site of the problem the tiles that local reasoning allows (arc consistency). Returns
/// nothing at all, an empty list, if some site has none: then there is no map.
std::vector<TileMask> consistent_domains(const Problem& problem);

/// Makes a map that keeps all pairs and all rules about single sites; global rules come later.
///
/// Blocks of the map are filled in order, each bounded by what stands: by collapse(), then by the solver. A
/// block that has no solution is grown over what stands, until it is the whole map, so that the answer is a
/// map or a proof that there is none. `domains` are those of consistent_domains().
Outcome make_start(const Problem& problem, const std::vector<TileMask>& domains, RandomStream& random,
                   const StopSignal& stop, Grid& map);

/// Makes a map by the solver alone, whole at once.
Outcome solve_whole(const Problem& problem, const std::vector<TileMask>& domains, RandomStream& random,
                    const StopSignal& stop, Grid& map);

}  // namespace solitaire::tiles
