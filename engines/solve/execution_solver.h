#pragma once
#include <functional>
#include <map>
#include <memory>
#include <set>

#include "engines/engine.h"
#include "engines/solve/explore.h"
#include "engines/solve/min_distance.h"
#include "engines/solve/pins.h"
#include "smt/solver.h"
#include "tracegraph/assignment.h"

namespace solitaire {

/// Which solver decides the formula, and on which encoding of it.
enum class Backend : std::uint8_t {
  kCadical,
  kZ3,
  /// As the dissertation has it, to measure against: 16 bits for every int (section 4.2.1), Z3's default
  /// solver, unexplored sides asserted not to be taken (R in figure 4.3) and the all-different constraint of
  /// section 4.2.3. It takes random exploration only (section 4.1.4), and gives choices no random values.
  kThesis,
};

/// The back end itself, or where its answers are no proofs, the default one.
constexpr Backend exact_backend(Backend backend) {
  return backend == Backend::kThesis ? Backend::kCadical : backend;
}

/// What is to be known of the things that a solution places into the scene.
enum class SceneDetail : std::uint8_t {
  kNone,        // nothing
  kPlacements,  // what they are, and where
  kProvenance,  // and the choices on which that depends
};

/// Which solutions are run again after they were found, which checks that the program accepts them.
enum class Replay : std::uint8_t {
  kEvery,
  /// The first solution and those with the numbers 16, 256, 4096, ... are run. The others are read off the
  /// trace, in about a tenth of the time, where it says all that the program does.
  kSome,
};

struct TracingOptions {
  Exploration exploration;
  Backend backend = Backend::kCadical;
  std::uint64_t seed = 0;
  bool diverse = true;  // solutions that differ much, at some cost in speed
  Replay replay = Replay::kEvery;
  SceneDetail scene = SceneDetail::kProvenance;  // of solutions
  bool far_apart = false;                        // and of these the most different ones
  /// Of solutions that look alike one will do: not all need to be found, where they are gone through in
  /// order.
  bool one_of_alike = false;
  bool relax = false;  // asserts may be broken, as few as possible
  /// Seconds from the start of the search for a solution after which it is no longer made better.
  std::optional<double> improvement_time;
  std::vector<Pin> pins;
  DistanceBound min_distance;  // of choices, from solutions to keep away from
  std::uint64_t effort = 0;    // conflicts after which the solver gives a question up; 0: none
  Limits limits;               // of one execution; its stop signal ends the work
};

/// Where the time went, in seconds, and how many solutions were run again.
struct TracingTimes {
  double explore = 0, encode = 0, solve = 0, replay = 0;
  std::uint64_t replays = 0;

  TracingTimes& operator+=(const TracingTimes& other) {
    explore += other.explore;
    encode += other.encode;
    solve += other.solve;
    replay += other.replay;
    replays += other.replays;
    return *this;
  }
};

/// Adds the time until its end to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum) {}
  ~Stopwatch() { sum_ += std::chrono::duration<double>(StopSignal::Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& sum_;
  StopSignal::Clock::time_point start_ = StopSignal::Clock::now();
};

/// The choices that an execution meets: the node of each, and its value.
using Answers = std::map<AddressId, std::pair<NodeId, std::int64_t>>;

/// Looks for executions of a program that fulfil conditions: the trace graph of the program, grown where that
/// is needed, and a solver that knows its formula.
///
/// Blockers are assumed false; if nothing is found, the unsatisfiable core names those that stood in the way,
/// and the exploration goes on there. A core without blockers proves that there is no such execution.
class ExecutionSolver {
 public:
  /// Which of a trace's requirements hold in every execution that is looked for. The others are the
  /// business of whoever asks.
  using Firm = std::function<bool(const TraceAssert&)>;

  /// `choices` answers what is not to be left open. `stream` tells apart solvers of one seed.
  ExecutionSolver(const Program& program, ParamValues params, const TracingOptions& options, Choices& choices,
                  Graph& graph, AddressTable& addresses, Firm firm, std::uint64_t stream = 0);
  ~ExecutionSolver();

  /// Runs the first passes, as far as the policy goes by itself. Throws Interrupted.
  void explore();
  /// Opens every side that some execution comes to, until none is left; false if the policy or the number
  /// of passes does not allow that. Throws Interrupted.
  bool explore_fully(std::size_t most_passes = SIZE_MAX);

  enum class Outcome : std::uint8_t {
    kFound,
    kNone,        // proved
    kWrapped,     // none for a solver whose ints wrap
    kUnexplored,  // none on the paths that the policy explores
    kStopped,     // a limit came first, of effort too
  };
  /// Conditions that depend on the newest pass. They may only say what a longer execution that begins like
  /// one of the trace cannot undo, as a broken assert is; or else they hold where unexplored() does.
  using Conditions = std::function<std::vector<NodeId>()>;
  /// Where an execution may end, and still be found, but at the end of the program: at a mistake, or what a
  /// pass cannot express; and where its path was cut, since it runs for long.
  enum class Ends : std::uint8_t { kNone, kMistakes, kMistakesAndCuts };
  /// Looks for an execution that fulfils the conditions. They are asked for again after each further pass.
  Outcome find(const Conditions& conditions, Ends ends = Ends::kNone);
  /// Whether an execution on the paths explored so far fulfils the conditions, which may come to mistakes.
  Outcome find_explored(const Conditions& conditions, Ends ends = Ends::kNone);

  /// From now on one of the conditions holds.
  void add_clause(std::span<const NodeId> conditions) { solver_->add_clause(conditions); }
  /// Has the next search start from random values of the choices: it then ends at a solution near them, and
  /// not near the last one. What is found depends on the index.
  void suggest_random_values(std::uint64_t index);

  /// Where an execution leaves the paths that were explored: what the trace says of it is not all.
  NodeId unexplored();

  /// As Solver::exact.
  bool exact() const { return solver_->exact(); }

  // After kFound:
  Answers answers();
  /// The choices that an execution with these values of the variables meets. `complete` says whether it
  /// stays on explored paths.
  Answers answers(Assignment& assignment, bool* complete = nullptr) const;
  Assignment assignment();
  // After kNone: the conditions in the core.
  const std::vector<NodeId>& core() const { return core_; }

  const Trace& trace() const { return explorer_.pass().trace; }
  const SymbolicPass& pass() const { return explorer_.pass(); }
  std::size_t passes() const { return explorer_.passes(); }
  TracingTimes& times() { return times_; }
  const TracingTimes& times() const { return times_; }

 private:
  bool asserts_closed_sides() const { return options_.backend == Backend::kThesis; }
  void sync();
  std::vector<NodeId> closed_sides(Ends ends) const;
  Verdict check(std::vector<NodeId> assumptions);
  std::vector<std::size_t> blockers_in_core() const;
  bool open(const std::vector<std::size_t>& blockers);

  Graph& graph_;
  AddressTable& addresses_;
  TracingOptions options_;
  Firm firm_;
  Explorer explorer_;
  std::unique_ptr<Solver> solver_;
  std::set<std::uint32_t> required_;  // conditions the solver knows
  std::vector<NodeId> core_;
  StopSignal never_;
  TracingTimes times_;
  std::size_t synced_pass_ = 0;
};

}  // namespace solitaire
