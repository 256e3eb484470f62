#pragma once
#include <memory>
#include <span>

#include "smt/solver.h"

namespace solitaire {

/// Goes through all values of the choices under which conditions hold, each once: depth first with unit
/// propagation, and on to the next by turning the last decision round (chronological backtracking; Grumberg,
/// Schuster and Yadgar 2004). It needs no clause for a model that it has left behind, so that nothing grows
/// with their number. It learns nothing either: where a search is hard, it gives up.
class Enumerator {
 public:
  /// `choices` are the numbers of the variables whose values make models different; the conditions depend on
  /// no others.
  Enumerator(const Graph& graph, std::span<const NodeId> conditions, std::span<const std::size_t> choices);
  ~Enumerator();

  enum class Outcome : std::uint8_t { kFound, kNone, kStopped, kTooHard };
  /// The next model. An outcome but kFound is the last.
  Outcome next(const StopSignal& stop);
  /// After kFound: the value of one of the choices.
  std::int64_t value(std::size_t variable) const;

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

}  // namespace solitaire
