#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/random.h"
#include "base/stop_signal.h"
#include "smt/cdcl/choice_search.h"
#include "smt/cdcl/conflict_analysis.h"
#include "smt/cdcl/vmtf_queue.h"
#include "smt/sat/graph_clauses.h"
#include "smt/tuning.h"

namespace solitaire {

/// Searches for a model near suggested values of the choices, depth first, and learns a clause from each
/// conflict (conflict-driven clause learning; Marques-Silva and Sakallah 1996).
///
/// - Variables that had a part in the last conflicts are decided first. When none of these is open, the
///   choice with the fewest values left is next. It gets the suggested value or, if that is ruled out, one of
///   the values that are left, at random. A variable that is decided again gets the value that it had before.
/// - The clauses are used as they stand, without the preprocessing of solvers for large formulas. This takes
///   a fraction of their time where there are many models. Where there are few, the search gives up, and
///   after fewer conflicts each time.
/// - Every model that it finds is one. That it finds none proves nothing.
class NearbySearch {
 public:
  /// Searches in the clauses that were written into the propagator, for choices of the graph they come from.
  /// `forgets` is the percentage of searches that begin without regard to earlier conflicts. The more do, the
  /// farther apart models are, and the longer the searches.
  NearbySearch(Propagator& propagator, GraphClauses& clauses, std::uint64_t seed, unsigned forgets)
      : propagator_(propagator),
        cnf_(clauses.cnf()),
        choices_(clauses.choices()),
        search_(propagator),
        random_(seed, Purpose::kNearby, 0),
        forgets_(forgets) {}

  /// Has the searches to come try that value of a choice first.
  void suggest(std::size_t variable, std::int64_t value);
  /// Returns the value suggested last for a choice, if any.
  std::optional<std::int64_t> suggestion(std::size_t variable) const;

  /// Returns true if it found a model under the assumptions, which stays in the propagator until end(). It
  /// gives up after some conflicts, or when the signal comes.
  bool find(std::span<const int> assumptions, const StopSignal& signal);
  /// Takes all decisions back.
  void end();
  /// Returns the literals that the last search wanted to hold, one for each input of a choice.
  std::vector<int> wanted() const;

 private:
  void take_suggestions();
  void add_choice(std::size_t variable);
  bool assume(std::span<const int> assumptions);
  bool search(const StopSignal& signal);
  std::uint64_t most_conflicts() const;
  bool search_within(std::uint64_t conflicts, std::size_t assumed, const StopSignal& signal);
  bool learn(std::size_t assumed);
  void undo_to(std::size_t decisions);
  int next_decision();
  int decision(std::size_t choice) const;
  int wanted(int variable) const { return wants(variable) ? variable : -variable; }
  bool wants(int variable) const {
    const auto at = static_cast<std::size_t>(variable);
    return at < wanted_.size() && wanted_[at] != 0;
  }
  void want(int variable, bool holds);
  bool is_left(std::size_t choice) const;
  void draw(std::size_t choice);

  Propagator& propagator_;
  Cnf& cnf_;
  const ChoiceEncoding& choices_;
  ChoiceSearch search_;
  ConflictAnalysis analysis_;
  VmtfQueue queue_;
  RandomStream random_;
  std::vector<std::optional<std::int64_t>> suggestions_;  // by variable of the graph
  std::vector<std::optional<std::size_t>> numbers_;       // of choices in search_, by variable of the graph
  std::vector<bool> ordered_;                             // by choice of search_, see ChoiceEncoding::order
  std::vector<char> wanted_;                              // by variable
  const unsigned forgets_;
  std::optional<std::uint64_t>
      conflicts_;  // the next search gives up after so many; the first after the most
};

}  // namespace solitaire
