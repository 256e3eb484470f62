#pragma once
#include <vector>

#include "solitaire/run/evaluator.h"

namespace solitaire {

/// Returns conditions that leave one of several solutions which look alike because things of one kind change
/// places: the one whose choices come first in lexicographic order.
///
/// Things change places where the choices below two turns of a loop do, and the conditions, the program's
/// value and what it places (but for names and extras) stay as they are. This is decided on the
/// expressions as they stand, up to the order of operands, so not every symmetry is found. Each condition is
/// the lex-leader constraint (Crawford, Ginsberg, Luks and Roy 1996) of such a swap, all in the order of the
/// graph's variables, so they can hold together. Looks for no more than some seconds.
std::vector<NodeId> symmetry_breaking(Graph& graph, const AddressTable& addresses, const SymbolicPass& pass,
                                      const std::vector<NodeId>& conditions);

}  // namespace solitaire
