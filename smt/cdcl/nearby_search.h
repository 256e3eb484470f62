#pragma once
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include "smt/cdcl/choice_search.h"
#include "smt/cdcl/conflict_analysis.h"
#include "smt/cdcl/vmtf_queue.h"
#include "smt/sat/bit_blast.h"
#include "smt/solver.h"

namespace solitaire {

/// Looks for a model near suggested values of the choices, depth first, and learns a clause from each
/// conflict (Marques-Silva and Sakallah 1996). It decides what had a part in the last conflicts, and where
/// there is nothing of that left, the choice with the fewest values left: to what is suggested or, where that
/// is out, to one of these at random. What is decided anew gets the value that it had before.
///
/// It takes the clauses as they stand, with none of the preparations of a solver for large formulas, so it
/// needs a fraction of the time of one where models are many. Where they are few, it gives up, sooner from
/// time to time.
class NearbySearch {
 public:
  /// Of the clauses that `cnf` writes into the propagator, for choices of the blaster.
  /// `forgets`: percent of the searches that begin without regard to earlier conflicts. The more do, the
  /// farther apart models are, and the longer the searches.
  NearbySearch(Propagator& propagator, Cnf& cnf, BitBlaster& blaster, std::uint64_t seed, unsigned forgets)
      : propagator_(propagator),
        cnf_(cnf),
        blaster_(blaster),
        search_(propagator),
        random_(seed),
        forgets_(forgets) {}

  /// A value to try first.
  void suggest(std::size_t variable, std::int64_t value);
  std::optional<std::int64_t> suggestion(std::size_t variable) const;

  /// Whether there is a model under the assumptions, as far as can be seen soon. The model is in the
  /// propagator until end(). Gives up when the signal comes.
  bool find(std::span<const int> assumptions, const StopSignal& signal);
  /// Takes all decisions back.
  void end();
  /// The literals that the last search wanted to hold, each of another input of a choice.
  std::vector<int> wanted() const;

 private:
  static constexpr std::uint64_t kMostConflicts = 1000;
  static constexpr std::uint64_t kFewestConflicts = 8;

  void take_suggestions();
  void add_choice(std::size_t variable);
  bool assume(std::span<const int> assumptions);
  bool search(const StopSignal& signal);
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
  std::size_t below(std::size_t bound);

  Propagator& propagator_;
  Cnf& cnf_;
  BitBlaster& blaster_;
  ChoiceSearch search_;
  ConflictAnalysis analysis_;
  VmtfQueue queue_;
  std::mt19937_64 random_;
  std::vector<std::optional<std::int64_t>> suggestions_;  // by variable of the graph
  std::vector<std::optional<std::size_t>> numbers_;       // of choices in search_, by variable of the graph
  std::vector<bool> ordered_;                             // by choice of search_, see BitBlaster::is_ordered
  std::vector<char> wanted_;                              // by variable
  const unsigned forgets_;
  std::uint64_t conflicts_ = kMostConflicts;  // after which the next search gives up
};

}  // namespace solitaire
