#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// A float as a sum of products of nodes, each with a number for a factor, and of a number. What is alike is
/// counted together, so that of a sum over data often nothing is left but sums of the data: of t (y - a x)
/// over all x and y, Y t - X a t.
///
/// A product of two sums is not multiplied out: where the sums are small differences of large numbers,
/// nothing exact would be left of it.
class Combination {
 public:
  /// The numbers of up to four nodes, in ascending order, behind zeros.
  using Factors = std::array<std::uint32_t, 4>;
  struct Part {
    Factors factors;
    double times;
  };

  Combination() = default;
  explicit Combination(double number) : number_(number) {}
  /// What the node is, as far as it is a short sum of products.
  Combination(const Graph& graph, NodeId node);

  bool is_number() const { return parts_.empty(); }
  bool is_zero() const { return is_number() && number_ == 0; }
  bool is_finite() const;
  double number() const { return number_; }

  void add(const Combination& more, double factor = 1);
  void add_number(double more);
  void add_part(const Part& more);
  /// Counts alike parts together and sorts them. All functions but add() want that.
  void settle();
  /// Its parts, settled.
  std::vector<Part>& parts() { return parts_; }

  /// The value as a node.
  NodeId node(Graph& graph) const;
  /// A combination that is long becomes a node, so that combinations of it stay short.
  void bound(Graph& graph);

  static Combination product(Graph& graph, const Combination& a, const Combination& b);

 private:
  static Combination atom(NodeId node);
  bool is_one_part() const { return parts_.size() == 1 && number_ == 0; }
  std::optional<Combination> times(const Part& factor) const;

  double number_ = 0;
  std::vector<Part> parts_;
  std::optional<NodeId> whole_;  // a node that has the value, if one is known
};

}  // namespace solitaire
