#pragma once
#include <cstddef>
#include <cstdint>

/// The numbers of smt/ that were found by measuring, each with what was measured. Times are CPU times of the
/// problems in bench/compare on one core of an AMD EPYC; "workspace" and the like are rows there.
namespace solitaire::tuning {

// ---- Clauses (sat/)

/// The largest number of values for which an int is written in order encoding, and not in bits. With orders,
/// workspaces of four groups came ten times faster than with bits alone. Larger ints have fewer bits than
/// values, and shorter clauses.
inline constexpr std::uint64_t kMostOrdered = 1024;
/// A choice of more values than this is written in order encoding only if its order is read more often than
/// its bits. All 12,880 solutions of x + y == s, each from 0 to 300, took 0.6 s in orders and 0.1 s in bits.
inline constexpr std::uint64_t kMostAlwaysOrdered = 256;
/// The same where an int is one of two, or the smaller or the larger one: each value takes a gate, and a list
/// of which one element is chosen has as many such ints as elements.
inline constexpr std::uint64_t kMostOrderedOfTwo = 256;
/// The largest number of pairs of values for which a sum of two ordered ints is ordered, too. Each pair takes
/// a gate.
inline constexpr std::uint64_t kMostOrderedSum = 1024;

/// A sum of more pairs, up to so many, is ordered if it has a comparison for each so many of them, as in
/// `distinct`. The best Golomb ruler of 8 marks took 1.9 s with such sums in
/// bits, and 0.5 s in order.
inline constexpr std::uint64_t kMostComparedSum = 16'384;
inline constexpr std::uint64_t kComparedPairs = 256;

/// A comparison of sums is a linear implication if it has so many terms at least, and not more. Two ints in
/// order encoding compare without; and what many comparisons share is worth being written once.
inline constexpr std::size_t kLeastLinearTerms = 4;
inline constexpr std::size_t kMostLinearFormTerms = 100'000;
/// A bound on a sum is written in unary if its tree has so many pairs of values at most. A pair takes a
/// clause at most, so that is a second.
inline constexpr std::size_t kMostUnaryPairs = 3'000'000;
/// None of its terms may have more values than this. With wider ones, as of what the distances on a ruler add
/// up to, the best ruler of 8 marks took 3 times as long, and Steiner's triples of 9 points as well; towers
/// of bricks and rosters, whose terms are narrow, took the same for 2, 8 and 16.
inline constexpr std::size_t kMostInUnaryTerm = 8;
/// Counts of at most so many pairs of values are added up pair by pair. Tile maps of 24 by 24 with bounds on
/// how many there are of three kinds took 18 to 25 s with 1024, 4 to 8 s with this, 7 to 28 s with 40,000,
/// and 4 to 24 s if all counts were added up pair by pair (four seeds).
inline constexpr std::size_t kMostMergedByPairs = 10'000;
/// That at most one of so many literals holds is said pair by pair.
inline constexpr std::size_t kMostPairwise = 5;
/// More of them are put into groups of so many.
inline constexpr std::size_t kCommanderGroup = 4;

/// A condition on one choice or two is written as a table for so many pairs of values at most, and the nodes
/// that are evaluated for all tables are at most so many. Judgement: that takes a second at the most.
/// Knight's tours of 8 by 8 took 0.2 s with tables, and more than a minute without.
inline constexpr std::uint64_t kLargestTable = 16'384;
inline constexpr std::uint64_t kMostTableEvaluations = 100'000'000;
/// In a table, values that do not fit are ruled out one run after the other if they lie in so many runs,
/// since that needs no further literals.
inline constexpr std::size_t kFewRuns = 2;

/// A conjunction in a clause of at most so many other literals makes as many clauses as it has operands, all
/// with these literals; in a longer clause it gets a variable of its own.
inline constexpr std::size_t kMostRepeated = 3;

/// The literals for which a list of clauses reserves memory. A list that grows step by step is copied and has
/// its old and its new memory in use at the same time; memory that is reserved and never written costs
/// nothing. The first solution of a workspace of three groups took 13.6 ms with this and other lists that do
/// not grow, and 14.6 ms without.
inline constexpr std::size_t kUsualLiterals = std::size_t{1} << 18;

// ---- The search near suggestions (cdcl/)

/// The search gives up after at most so many conflicts, or one for so many clauses that conditions on ints
/// stand for, since telling CaDiCaL millions of clauses takes seconds. A first workspace of three groups
/// takes some 150, one of six groups 250. Limits of 100 to 3,000 made no difference for twelve queens far
/// apart. Workspaces of 24 groups took 3 to 9 s, most of it in CaDiCaL, with a limit of 1000, and 0.8 s with
/// 3,000, 10,000 and 30,000 alike; tile maps of 48 by 48, of which there are no such conditions, took four
/// times as long with 4,000.
inline constexpr std::uint64_t kMostConflicts = 1000;
inline constexpr std::uint64_t kClausesPerConflict = 1000;
/// A search that gave up makes the next one give up four times as soon, though not before so many conflicts.
inline constexpr std::uint64_t kFewestConflicts = 8;
/// After a search, the older half of the learned clauses is forgotten if there are more than so many. To
/// forget by quality and not by age made twelve queens far apart no faster.
inline constexpr std::size_t kMostLearned = 1000;
/// The stop signal is looked at after so many conflicts.
inline constexpr std::uint64_t kConflictsPerLookNearby = 64;

/// What brings models apart, in percent.
struct Spread {
  unsigned searches_that_forget;  // searches near suggestions that begin without what earlier ones met
  unsigned random_signs;  // variables that stand for no choice, of which CaDiCaL tries a random sign first
  /// CaDiCaL begins anew where the distance of its model from one of its last is a smaller share of their
  /// mean distance from each other; see "Random values" in docs/engine.md. Models that it comes back to are
  /// nearly the same: of tile maps, the nearest two are as far apart with 12 as with 33. In tight rooms of
  /// two groups, models are nearer than others anyway, and 101 took 29 to 74 % longer with 33.
  unsigned near_models;
};
/// 100 solutions of platforms-6 have a mean distance of 0.77 in 61 ms if no search forgets, 0.80 in 68 ms if
/// one in eight does, and 0.81 in 83 ms if all do; docs/engine.md has more rows.
inline constexpr Spread kUsualSpread{12, 10, 12};
inline constexpr Spread kFarApart{100, 100, 67};

/// CaDiCaL follows the values that the search had come to for so many conflicts. A search that tries given
/// values first, whatever it learns, can take forever where things stand close.
inline constexpr std::uint64_t kConflictsNearSuggestions = 300;

/// CaDiCaL goes its own way for so many conflicts before it begins at the ends of the ranges, and there.
/// Connected maps of 12 by 12, half of them land, took 8 s from random values, 0.1 s from greatest ones, and
/// 13 s from least ones. With 3000, workspaces of three groups took up to half as long again, as they were
/// about to be found; with this they take as long as without, and those of five a third of it.
inline constexpr std::uint64_t kConflictsOfOneWay = 8000;

/// Where its model is near one of its last ones, CaDiCaL begins anew so often at most for one model, and
/// looks at so many of the last ones. Judgement.
inline constexpr unsigned kNewBeginnings = 3;
inline constexpr std::size_t kModelsToLeave = 16;

/// Another search takes over from the enumerator after so many dead ends without a model. It finds the first
/// model where the enumerator has found none after the fewer.
inline constexpr std::uint64_t kMostDeadEnds = 50'000;
inline constexpr std::uint64_t kFewDeadEnds = 200;
/// The enumerator learns from dead ends after so many without a model, and at once where it began near one:
/// that made further buildings and platforms two to ten times as fast, but 12 queens, which have a model
/// every few dead ends, half as slow again.
inline constexpr std::uint64_t kDeadEndsToLearn = 100;
/// The enumerator looks at the stop signal after so many dead ends.
inline constexpr std::uint64_t kDeadEndsPerLook = 256;

// ---- CaDiCaL (sat/cadical.cpp)

/// How many conflicts CaDiCaL lets pass between two rounds of eliminating variables, probing and subsumption.
/// A search after the search near suggestions is short, and what simplifying gains is lost with the next
/// clause, so these are ten times the values that CaDiCaL has by itself.
inline constexpr int kEliminationInterval = 20'000;
inline constexpr int kProbingInterval = 50'000;
inline constexpr int kSubsumptionInterval = 100'000;
/// How many conflicts CaDiCaL lets pass before it forgets learned clauses, by itself 300. As solutions are
/// asked for one after the other, what was learned is worth keeping for a while.
inline constexpr int kReductionInterval = 1'000;
/// CaDiCaL asks all the time whether it should stop; the clock is looked at once in so many times.
inline constexpr unsigned kCadicalQuestionsPerLook = 256;

// ---- Z3 (z3/)

/// The resources that Z3 counts for a linear program; about a second.
inline constexpr unsigned kMostLinearEffort = 5'000'000;

// ---- CryptoMiniSat (xor/)

/// The stop signal is looked at after so many conflicts.
inline constexpr std::uint64_t kConflictsPerLookXor = 2000;

}  // namespace solitaire::tuning
