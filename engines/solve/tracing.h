#pragma once
#include "engines/solve/execution_solver.h"
#include "smt/cdcl/enumerator.h"

namespace solitaire {

/// The choices of a solution that is known from before.
using KnownChoices = std::vector<AnsweredChoice>;

/// None of a program's choices is where a pin says; the message names those nearest.
class UnmatchedPin : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Solitaire as the dissertation has it (Algorithm 2): explore the program into a trace graph, compile the
/// graph to a formula, solve it under the constraint that the solution is a new one, and replay each
/// solution.
///
/// Where the program has wishes, or asserts may be broken, the best solution that is left comes first: found
/// by bisection between the best so far and what has been proved impossible.
class TracingEngine : public Engine {
 public:
  /// `first` is the number of the first solution that it is to find; engines with others find others.
  TracingEngine(const Program& program, ParamValues params, const TracingOptions& options,
                std::uint64_t first = 0);
  ~TracingEngine() override;

  /// As Engine::next. Where a limit comes while a solution is made better, it is returned as it is.
  /// Throws UnmatchedPin.
  std::optional<Solution> next() override;
  Ending ending() const override { return ending_; }
  const AddressTable& addresses() const override { return addresses_; }

  /// Keeps a solution that is known from before from being found.
  void exclude(const KnownChoices& choices);
  /// From now on solutions are at least TracingOptions::min_distance from this one.
  void keep_away_from(const KnownChoices& choices);
  /// Runs a known solution. Throws NotASolution and Interrupted.
  Solution run(const KnownChoices& choices);
  /// Runs the solution with these values of the choices, which fulfil formula(). Throws Interrupted.
  Solution run(Assignment assignment);
  /// Told of each solution that is better than the one before, while the next one is looked for.
  void on_improvement(std::function<void(const Solution&)> told) { told_ = std::move(told); }

  const Graph& graph() const { return graph_; }
  Graph& graph() { return graph_; }
  const SymbolicPass& pass() const { return solver_.pass(); }
  std::size_t passes() const { return solver_.passes(); }
  const TracingTimes& times() const { return solver_.times(); }
  /// Explores without solving, as far as the policy goes by itself. Throws Interrupted.
  void explore() { solver_.explore(); }
  /// Explores every path that an execution can take; false if the policy does not allow that, or if it takes
  /// more passes than kMostPasses, as where there are endlessly many. Throws ProgramError for a mistake that
  /// an execution can come to, UnmatchedPin, and Interrupted.
  bool explore_fully();
  static constexpr std::size_t kMostPasses = 200;
  /// Looks for mistakes in what has been explored so far; false if a limit came first. Throws ProgramError.
  bool check_mistakes();
  /// Looks into every side that an execution can come to, for all mistakes: each with the choices that lead
  /// there, which have been run. `complete` says whether no limit came first.
  std::vector<Diagnostic> find_mistakes(bool* complete);
  /// All that holds in the solutions that are left, on the paths explored so far; on any path, once it is
  /// proved that there are none.
  std::vector<NodeId> formula();

 private:
  using Outcome = ExecutionSolver::Outcome;
  struct Known {
    ChoiceValues values;
    /// What the solver was told last: one of them holds. Nothing while the solution is on unexplored paths.
    std::optional<std::vector<NodeId>> differs;
  };
  struct KeptAway {
    ChoiceValues values;
    std::size_t told_in_pass = 0;  // the last one that the solver was told of it in
  };
  struct Found {
    Solution solution;
    std::int64_t rank = 0;  // the objective's value
  };

  void meet_pass();
  void check_pins();
  void report_reachable_mistakes();
  Diagnostic diagnose(const TraceProgramError& mistake);
  std::string leading_choices(const TraceProgramError& mistake, const Answers& answers) const;
  void exclude_known(Known& known);
  Outcome find(std::optional<std::int64_t> most);
  std::optional<Found> attempt(std::optional<std::int64_t> most);
  void exclude_model(const Answers& answers);
  bool exclude_repeated(const ChoiceValues& values);
  bool require_distance(const ChoiceValues& values);
  NodeId distance_condition(const KeptAway& kept);
  std::vector<NodeId> differing(const Answers& answers);
  void improve(Found& best, StopSignal::Clock::time_point start);
  void remember(ChoiceValues values);
  bool excludes_at_once() const;
  void exclude_all_known();
  bool can_enumerate() const;
  std::unique_ptr<Enumerator> make_enumerator();
  std::optional<Solution> next_enumerated();
  Found take_solution(Assignment& assignment);
  std::optional<Execution> read(Assignment& assignment);
  std::optional<Execution> read(const KnownChoices& choices);
  ChoiceValues addressed(const KnownChoices& choices);
  Assignment assignment_of(const ChoiceValues& values, bool& possible) const;
  void check_reading(const Execution& read, Assignment& assignment);
  Execution replay(const Answers& answers);
  void complete(Solution& solution);
  void add_object_choices(Solution& solution);
  void add_broken_choices(Solution& solution);
  std::set<std::string> choices_below(const TraceAssert& part);
  static Ending ending_of(Outcome outcome);

  const Program& program_;
  ParamValues params_;
  TracingOptions options_;
  Limits limits_;  // of executions
  Graph graph_;
  AddressTable addresses_;
  StopSignal solution_stop_;  // of the search for one solution, part of the whole
  Pins pins_;
  PinnedChoices choices_;
  ExecutionSolver solver_;
  std::function<void(const Solution&)> told_;
  struct WideTrace;
  std::unique_ptr<WideTrace> wide_;  // once it is needed
  Ending ending_ = Ending::kNone;
  std::size_t met_pass_ = 0;
  NodeId objective_ = kFalse;
  std::int64_t proved_ = INT64_MIN;         // no solution that is left has a lower rank
  bool last_was_best_ = false;              // the last solution has the rank proved_
  std::unique_ptr<Enumerator> enumerator_;  // while it is what finds solutions
  std::vector<NodeId> breaking_;            // of symmetries, while it does
  bool may_enumerate_;
  std::vector<Known> known_;
  std::unordered_multimap<std::uint64_t, std::size_t> by_hash_;  // numbers of known solutions
  std::size_t repeated_ = 0;                                     // models that were known solutions
  std::vector<KeptAway> kept_away_;
  std::uint64_t taken_;   // solutions, by this engine and those before it
  std::uint64_t number_;  // of the next solution, which its random values depend on
};

}  // namespace solitaire
