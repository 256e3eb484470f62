#pragma once
#include <memory>
#include <span>

#include "smt/solver.h"

namespace solitaire {

/// Goes through all values of the choices under which conditions hold, and gives each once. It searches depth
/// first with unit propagation, and goes on to the next model by replacing the last decision by its negation
/// (chronological backtracking; Grumberg, Schuster and Yadgar 2004). As it adds no clause against a model
/// that it has left behind, nothing grows with their number. It learns nothing either, and gives up where the
/// search is hard.
class Enumerator {
 public:
  /// `choices` are the numbers of the variables whose values make models different; the conditions depend on
  /// no others.
  Enumerator(const Graph& graph, std::span<const NodeId> conditions, std::span<const std::size_t> choices);
  ~Enumerator();

  enum class Outcome : std::uint8_t { kFound, kNone, kStopped, kTooHard };
  /// Looks for the next model. After an outcome other than kFound it must not be called again.
  Outcome next(const StopSignal& stop);
  /// Returns the value of one of the choices. For use after kFound.
  std::int64_t value(std::size_t variable) const;

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

}  // namespace solitaire
