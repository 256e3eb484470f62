#include "smt/sat/cardinality.h"

#include <algorithm>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

#include "base/floor_division.h"
#include "smt/sat/order_encoded_int.h"
#include "smt/tuning.h"

namespace solitaire {
namespace {

/// Writes that at most one of the literals fails: of any two, one holds.
void write_pairs(Circuit& circuit, std::span<const Literal> literals, const Definition::Emit& emit) {
  for (std::size_t i = 0; i < literals.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Literal either[] = {literals[i], literals[j]};
      for (const Literal literal : either) circuit.use(literal);
      emit(either);
    }
  }
}

/// Writes the same for many literals: of each group at most one fails, and of the groups at most one has
/// some literal that fails.
void write_all_but_one(Circuit& circuit, std::vector<Literal> literals, const Definition::Emit& emit) {
  while (literals.size() > tuning::kMostPairwise) {
    std::vector<Literal> groups;
    for (std::size_t at = 0; at < literals.size(); at += tuning::kCommanderGroup) {
      const auto group =
          std::span(literals).subspan(at, std::min(tuning::kCommanderGroup, literals.size() - at));
      write_pairs(circuit, group, emit);
      Literal all = kTrueLiteral;
      for (const Literal literal : group) all = circuit.conjunction(all, literal);
      groups.push_back(all);
    }
    literals = std::move(groups);
  }
  write_pairs(circuit, literals, emit);
}

}  // namespace

std::optional<Cardinality> as_cardinality(const LinearBound& bound) {
  Cardinality made;
  std::int64_t least = bound.least, difference = 0;
  for (const auto& [of, factor] : bound.terms) {
    if (of->size() != 2) return std::nullopt;
    const std::int64_t low = factor * of->values[0], high = factor * of->values[1];
    if (difference != 0 && std::abs(high - low) != difference) return std::nullopt;
    difference = std::abs(high - low);
    least -= std::min(low, high);
    made.literals.push_back(of->reached[0] ^ (high < low));
  }
  if (difference == 0) return std::nullopt;
  made.least = -floor_divide(-least, difference);
  return made;
}

bool write_cardinality(Circuit& circuit, const Cardinality& cardinality, const Definition::Emit& emit) {
  const auto count = static_cast<std::int64_t>(cardinality.literals.size());
  const auto write = [&](std::span<const Literal> clause) {
    for (const Literal literal : clause) circuit.use(literal);
    emit(clause);
  };
  if (cardinality.least <= 0) return true;
  if (cardinality.least == 1) {
    write(cardinality.literals);
  } else if (cardinality.least == count) {
    for (const Literal& literal : cardinality.literals) write({&literal, 1});
  } else if (cardinality.least == count - 1) {
    write_all_but_one(circuit, cardinality.literals, emit);
  } else {
    return false;
  }
  return true;
}

}  // namespace solitaire
