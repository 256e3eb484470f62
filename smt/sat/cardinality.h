#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "smt/sat/circuit.h"

namespace solitaire {

/// So many of the literals hold at least.
struct Cardinality {
  std::vector<Literal> literals;
  std::int64_t least = 0;
};

/// Returns a linear bound as a cardinality, if each of its ints has two values, and all make the same
/// difference.
std::optional<Cardinality> as_cardinality(const LinearBound& bound);

/// Writes clauses that say the same as a cardinality, if that takes few: where one has to hold, all, or all
/// but one, which is that at most one of their negations does. Returns false if it writes nothing. Many
/// literals are put into groups, of which each has a literal of its own (commander variables; Klieber and
/// Kwon 2007).
bool write_cardinality(Circuit& circuit, const Cardinality& cardinality, const Definition::Emit& emit);

}  // namespace solitaire
