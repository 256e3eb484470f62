#pragma once
#include <functional>
#include <memory>
#include <span>

#include "smt/solver.h"
#include "smt/tuning.h"

namespace solitaire {

/// Goes through all values of the choices under which conditions hold, and gives each once. It searches depth
/// first with unit propagation, and goes on to the next model by replacing the last decision by its negation
/// (chronological backtracking; Grumberg, Schuster and Yadgar 2004). As it adds no clause against a model
/// that it has left behind, nothing grows with their number.
///
/// Where models are far from each other it learns clauses from dead ends, and takes several decisions back at
/// once, but none below which it has found models (Gebser and others 2007, Conflict-driven answer set
/// enumeration). It gives up where the search is hard; from a model that another search has found, it can go
/// on to those next to it.
class Enumerator {
 public:
  /// `choices` are the numbers of the variables whose values make models different; the conditions depend on
  /// no others.
  Enumerator(const Graph& graph, std::span<const NodeId> conditions, std::span<const std::size_t> choices);
  ~Enumerator();

  enum class Outcome : std::uint8_t { kFound, kNone, kStopped, kTooHard };
  /// Looks for the next model, and gives up after so many dead ends. After an outcome other than kFound it
  /// must not be called again, but for what begin_near() allows.
  Outcome next(const StopSignal& stop, std::uint64_t most_dead_ends = tuning::kMostDeadEnds);
  /// Begins again, and from now on tries of each choice the value first that it has in this model. For use
  /// before a model has been found, also after kTooHard.
  void begin_near(const std::function<std::int64_t(std::size_t variable)>& value_of);
  /// Returns the value of one of the choices. For use after kFound.
  std::int64_t value(std::size_t variable) const;

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

}  // namespace solitaire
