#pragma once
#include <optional>
#include <span>

#include "engines/solve/conclusions/over_full.h"
#include "engines/solve/conclusions/separations.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// Looks among comparisons of ints for some that ask for more than others allow, as seen by adding up
/// multiples of them: a roster of which each day asks for five of eight nurses, while none of these works
/// more than four of seven days (35 turns, and 32 at most), or items that weigh more than their boxes hold.
///
/// The comparisons are read as linear facts, and fractions are looked for that fulfil them. If there are
/// none, there are no ints either. Before that, facts are left out that cannot take part: an unknown that all
/// facts want to be small is as small as it can be, and a fact that always holds then says nothing. Mostly
/// nothing is left, and nothing else has to be done; else it is a linear program in as many unknowns as there
/// are facts and their unknowns.
std::optional<OverFull> find_sum_conflict(Graph& graph, std::span<const SignedNode> comparisons);

}  // namespace solitaire
