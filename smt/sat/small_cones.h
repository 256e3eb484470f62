#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// Knows which conditions are better written as a table: those that depend on one choice or two, of few
/// values, and that compare ints which have no order encoding, as remainders and products.
class SmallCones {
 public:
  explicit SmallCones(const Graph& graph) : graph_(graph) {}

  /// Says whether a node is written in order encoding.
  using IsOrdered = std::function<bool(NodeId)>;
  /// Takes note of the nodes that are new in the graph.
  void meet_new(const IsOrdered& is_ordered);
  /// Returns the choices below a condition that is to be written as a table, or none if it is not to be. The
  /// answer stays the same. There are only so many tables, as each takes time by its size.
  std::span<const NodeId> tabled(NodeId condition);

 private:
  static constexpr std::uint8_t kMany = 3;

  struct Cone {
    std::array<NodeId, 2> choices{};
    std::uint8_t number = 0;  // of choices below the node, or kMany
    bool needs_bits = false;  // of some comparison
    enum class Decided : std::uint8_t { kNot, kTable, kNoTable } decided = Decided::kNot;
  };

  Cone cone_of(NodeId id, const IsOrdered& is_ordered) const;
  static void add(Cone& cone, const Cone& operand);
  bool is_worth(NodeId condition, const Cone& cone);

  const Graph& graph_;
  std::vector<Cone> cones_;        // by node
  std::uint64_t evaluations_ = 0;  // of nodes, that all tables take
};

}  // namespace solitaire
