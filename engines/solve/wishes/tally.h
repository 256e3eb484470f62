#pragma once
#include <cstddef>
#include <memory>
#include <vector>

#include "tracegraph/graph.h"

namespace solitaire {

/// Counts how much of something comes together, as conditions that so much of it does. They are made when
/// they are first asked for (a totalizer, Bailleux and Boufkhad 2003, that grows; Martins and others 2014).
class Tally {
 public:
  /// `reached` has the condition of 0, which always holds, of 1, and so on; each implies the one before it.
  explicit Tally(std::vector<NodeId> reached) : most_(reached.size() - 1), reached_(std::move(reached)) {}
  /// Counts all that the parts count. There is at least one.
  explicit Tally(std::vector<std::unique_ptr<Tally>> parts);
  /// Counts which of the conditions hold. There is at least one.
  static std::unique_ptr<Tally> of(const std::vector<NodeId>& conditions);

  /// Returns the number to which it can come.
  std::size_t most() const { return most_; }
  /// Returns the condition that it comes to so much, which is at most most().
  NodeId at_least(Graph& graph, std::size_t number);

 private:
  NodeId next(Graph& graph);

  std::size_t most_;
  std::vector<NodeId> reached_{kTrue};
  std::unique_ptr<Tally> one_, other_;
};

}  // namespace solitaire
