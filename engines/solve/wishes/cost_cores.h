#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engines/solve/wishes/tally.h"
#include "tracegraph/graph.h"

namespace solitaire {

/// A cost that is a sum of many weighted conditions, such as wishes, and what is known of the least that it
/// comes to: the algorithm OLL (Andres, Kaufmann, Matheis and Schaub 2012; Morgado, Dodaro and Marques-Silva
/// 2014), in strata (Ansotegui, Bonet and Levy 2012).
///
/// One asks for an execution in which all that is wanted() holds. If there is none, a core names some of it
/// that cannot hold together: one of these costs has to be paid, by the least of their weights at least, and
/// from then on it is wanted that no second one is. If there is one, what weighs less is wanted, too.
class CostCores {
 public:
  /// Returns nothing if the cost is not such a sum.
  static std::optional<CostCores> of(Graph& graph, NodeId cost);

  /// Returns conditions that cost nothing where they hold, in the strata so far.
  std::vector<NodeId> wanted() const;
  /// Returns true if an execution in which all of wanted() holds costs least().
  bool wants_all() const;
  /// Goes on with the next stratum.
  void want_more();
  /// Takes in that some of wanted() cannot hold together: those that are in the core. Returns false if none
  /// of it is.
  bool raise(std::span<const NodeId> core);
  /// Returns what an execution costs at least.
  std::int64_t least() const { return least_; }

 private:
  /// It costs the weight if a tally comes to the number.
  struct Cost {
    Tally* tally;
    std::size_t number;
    NodeId unpaid;  // the condition that it does not
    std::int64_t weight;
  };

  CostCores(Graph& graph, std::int64_t least) : graph_(&graph), least_(least) {}
  void add(std::unique_ptr<Tally> tally, std::size_t number, std::int64_t weight);
  void add(Tally& tally, std::size_t number, std::int64_t weight);

  Graph* graph_;
  std::vector<Cost> costs_;  // each condition once, and weights above 0
  std::vector<std::unique_ptr<Tally>> tallies_;
  std::int64_t stratum_ = 0;  // costs of this weight and more are wanted not to be paid
  std::int64_t least_;
};

}  // namespace solitaire
