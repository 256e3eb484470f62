#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "smt/sat/circuit.h"
#include "smt/sat/order_encoded_int.h"
#include "smt/tuning.h"

namespace solitaire {

/// A sum of multiples of ints in order encoding, as a balanced tree of sums (a totalizer, Bailleux and
/// Boufkhad 2003, with weights; Joshi, Martins and Manquinho 2015). Of each sum the tree has literals that
/// say that it reaches a value, but only those that are needed for what is asked.
///
/// A large count, a sum of terms that have two values each, all equally far apart, is merged from the odd and
/// the even values of both its halves (Batcher 1968), down to counts that are small (Abio and others 2013).
/// Of counts of n and n that takes about n log n clauses, where each pair of values would take one, and what
/// follows from clauses of pairs follows from these.
class UnarySum {
 public:
  struct Limits {
    std::size_t clauses;  // that the tree can need
    /// Counts whose halves have more pairs of values than this are merged.
    std::size_t pairs = tuning::kMostMergedByPairs;
  };

  /// Returns nothing if the tree could need more clauses than the limit.
  static std::optional<UnarySum> of(const LinearBound& bound, Limits limits);

  /// Returns a literal that holds where the sum is no less than the bound. Its clauses are those of a search
  /// in which it has to hold: as soon as the terms that are known leave too little for the rest, it is false.
  Literal at_least(Circuit& circuit, std::int64_t bound);

 private:
  /// Some of the values of a half, but for its lowest one: each so many after the one before.
  struct Strand {
    UnarySum* of = nullptr;
    std::size_t first = 0, count = 0;

    /// Returns the values with odd numbers, or those with even ones, of strands that are `stride` apart.
    Strand odd() const { return {of, first, (count + 1) / 2}; }
    Strand even(std::size_t stride) const { return {of, first + stride, count / 2}; }
  };
  /// What is asked of strands: that so many of their values are reached.
  struct Merged {
    std::size_t one, other, stride, number;
    friend auto operator<=>(const Merged&, const Merged&) = default;
  };

  UnarySum(OrderEncodedInt term, std::size_t most_pairs);
  UnarySum(std::unique_ptr<UnarySum> one, std::unique_ptr<UnarySum> other);

  static std::size_t most_clauses(const UnarySum& one, const UnarySum& other);
  static bool is_counted(const UnarySum& one, const UnarySum& other);
  Literal reaches(Circuit& circuit, std::size_t position);
  Literal by_pairs(Circuit& circuit, std::int64_t least);
  Literal merged(Circuit& circuit, Strand one, Strand other, std::size_t stride, std::size_t number);
  static Literal merged_by_pairs(Circuit& circuit, Strand one, Strand other, std::size_t stride,
                                 std::size_t number);

  std::size_t most_pairs_;                  // of values of a count's halves, where these are not merged
  std::vector<std::int64_t> values_;        // that the sum can have
  std::int64_t step_;                       // of a count, by which each term can add to it; else 0
  std::unique_ptr<OrderEncodedInt> term_;   // of a leaf
  std::unique_ptr<UnarySum> one_, other_;   // of all others
  std::map<std::size_t, Literal> reached_;  // by position in the values
  std::map<Merged, Literal> merged_;
};

}  // namespace solitaire
