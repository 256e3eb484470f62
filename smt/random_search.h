#pragma once
#include <array>
#include <cstdint>
#include <random>

#include "smt/bit_blast.h"
#include "smt/choice_search.h"

namespace solitaire {

/// Looks for a model near suggested values of the choices: depth first with unit propagation, and where a
/// suggestion is out, with one of the values that are left at random. It learns nothing. So it takes a
/// fraction of the time of a search that does where models are many. Where they are few, it gives up, sooner
/// from time to time, and what it drew by then agrees with each other better than the suggestions did.
///
/// Two orders of the choices are tried: the program's, in which things are put one beside the other, and the
/// one with the fewest values left first.
class RandomSearch {
 public:
  /// Of the clauses that `cnf` writes into the propagator, for choices of the blaster.
  RandomSearch(Propagator& propagator, Cnf& cnf, BitBlaster& blaster, std::uint64_t seed)
      : propagator_(propagator), cnf_(cnf), blaster_(blaster), search_(propagator), random_(seed) {}

  /// A value to try first.
  void suggest(std::size_t variable, std::int64_t value);
  std::optional<std::int64_t> suggestion(std::size_t variable) const;

  /// Whether there is a model under the assumptions, as far as can be seen soon. The model is in the
  /// propagator until end().
  bool find(std::span<const int> assumptions);
  /// Takes all decisions back.
  void end();
  /// The literals that the last search wanted to hold, each of another input.
  std::vector<int> wanted() const;

 private:
  /// A choice that conditions have met.
  struct Choice {
    bool ordered = false;      // see BitBlaster::is_ordered
    std::vector<char> wanted;  // by input
  };

  struct Manner {
    ChoiceSearch::Order order;
    std::uint64_t most_dead_ends;              // after which it is given up
    std::uint64_t run;                         // dead ends after which it begins again with other values
    std::uint64_t dead_ends = most_dead_ends;  // of the next search
    double cost = 0;                           // dead ends of the last searches, the later the more
  };

  void take_suggestions();
  void add_choice(std::size_t variable);
  bool assume(std::span<const int> assumptions);
  bool search(Manner& manner, std::size_t assumed);
  bool descend(const Manner& manner, std::size_t assumed, std::uint64_t& left);
  void want_together(std::size_t assumed);
  void undo_to(std::size_t decisions);
  int decision(std::size_t choice) const;
  int literal(std::size_t choice, std::size_t input) const;
  void want_what_is_left(std::size_t choice);
  bool is_left(std::size_t choice) const;
  void draw(std::size_t choice);
  std::size_t below(std::size_t bound);

  Propagator& propagator_;
  Cnf& cnf_;
  BitBlaster& blaster_;
  ChoiceSearch search_;
  std::mt19937_64 random_;
  std::vector<std::optional<std::int64_t>> suggestions_;  // by variable
  std::vector<std::optional<std::size_t>> numbers_;       // of choices, by variable
  std::vector<Choice> choices_;                           // as of search_
  std::array<Manner, 2> manners_ = {Manner{ChoiceSearch::Order::kAsAdded, 128, 32},
                                    Manner{ChoiceSearch::Order::kFirstFail, 64, 64}};
};

}  // namespace solitaire
