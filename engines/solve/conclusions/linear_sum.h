#pragma once
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// What int nodes are sums of: multiples of other nodes, and a constant. Of sums, differences, multiples by
/// constants and `cond(b, 3, 0)` it is read what they are made of; everything else is a term by itself.
class LinearSum {
 public:
  /// A multiple of an int node, or of a bool node as 0 or 1.
  struct Term {
    NodeId node;
    Interval range;
    std::int64_t factor = 0;
  };

  explicit LinearSum(const Graph& graph) : graph_(graph) {}

  /// Adds a multiple of an int. Returns false if the sum then has too many terms, or too large ones; it is
  /// not to be used any more.
  bool add(NodeId node, std::int64_t factor);

  /// Each node once, in the order in which they were met. Factors can be 0.
  const std::vector<Term>& terms() const { return terms_; }
  std::int64_t constant() const { return constant_; }

 private:
  void add_term(NodeId node, Interval range, std::int64_t factor);

  const Graph& graph_;
  std::vector<Term> terms_;
  std::unordered_map<NodeId, std::size_t> places_;  // of the nodes among the terms
  std::int64_t constant_ = 0;
};

}  // namespace solitaire
