#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "smt/sat/circuit.h"
#include "smt/sat/order_encoded_int.h"

namespace solitaire {

/// A sum of multiples of ints in order encoding, as a balanced tree of sums (a totalizer, Bailleux and
/// Boufkhad 2003, with weights; Joshi, Martins and Manquinho 2015). Of each sum the tree has literals that
/// say that it reaches a value, but only those that are needed for what is asked.
class UnarySum {
 public:
  /// Returns nothing if the tree could need more clauses than `most`.
  static std::optional<UnarySum> of(const LinearBound& bound, std::size_t most);

  /// Returns a literal that holds where the sum is no less than the bound. Its clauses are those of a search
  /// in which it has to hold: as soon as the terms that are known leave too little for the rest, it is false.
  Literal at_least(Circuit& circuit, std::int64_t bound);

 private:
  explicit UnarySum(OrderEncodedInt term);
  UnarySum(std::unique_ptr<UnarySum> one, std::unique_ptr<UnarySum> other);

  std::vector<std::int64_t> values_;       // that the sum can have
  std::unique_ptr<OrderEncodedInt> term_;  // of a leaf
  std::unique_ptr<UnarySum> one_, other_;  // of all others
  std::map<std::int64_t, Literal> reached_;
};

}  // namespace solitaire
