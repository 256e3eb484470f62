#pragma once
#include <memory>
#include <set>

#include "engines/engine.h"
#include "engines/explore.h"
#include "smt/solver.h"

namespace solitaire {

/// Which solver decides the formula.
enum class Backend : std::uint8_t { kCadical, kZ3 };

struct TracingOptions {
  Exploration exploration;
  Backend backend = Backend::kCadical;
  std::uint64_t seed = 0;
  bool diverse = true;  // solutions that differ much, at some cost in speed
  Limits limits;        // of one execution; its stop signal ends the engine
};

/// Where the time of a TracingEngine went, in seconds.
struct TracingTimes {
  double explore = 0, encode = 0, solve = 0, replay = 0;
};

/// Solitaire as the dissertation has it (Algorithm 2): explore the program into a trace graph, compile the
/// graph to a formula, solve it under the constraint that the solution is a new one, and replay each
/// solution.
///
/// Blockers are assumed false; if nothing is found, the unsatisfiable core names those that stood in the way,
/// and the exploration goes on there. A core without blockers proves that there is no further solution.
class TracingEngine : public Engine {
 public:
  TracingEngine(const Program& program, ParamValues params, const TracingOptions& options);
  ~TracingEngine() override;

  std::optional<Solution> next() override;
  Ending ending() const override { return ending_; }
  const AddressTable& addresses() const override { return addresses_; }

  const Graph& graph() const { return graph_; }
  const SymbolicPass& pass() const { return explorer_.pass(); }
  std::size_t passes() const { return explorer_.passes(); }
  const TracingTimes& times() const { return times_; }
  /// Explores without solving, as far as the policy goes by itself.
  void explore();
  /// Looks for mistakes in what has been explored so far; false if a limit came first. Throws ProgramError.
  bool check_mistakes();

 private:
  void sync_solver();
  void report_reachable_mistakes();
  void suggest_values();
  std::vector<NodeId> assumptions(bool with_mistakes);
  Verdict check(const std::vector<NodeId>& assumptions);
  bool open_core();
  Solution take_solution();
  std::map<AddressId, std::pair<NodeId, std::int64_t>> model_choices();
  Execution replay(const std::map<AddressId, std::pair<NodeId, std::int64_t>>& answers);
  void add_object_choices(Solution& solution);
  void forbid(const std::map<AddressId, std::pair<NodeId, std::int64_t>>& answers);

  const Program& program_;
  ParamValues params_;
  TracingOptions options_;
  Graph graph_;
  AddressTable addresses_;
  Explorer explorer_;
  std::unique_ptr<Solver> solver_;
  std::set<std::uint32_t> required_;  // conditions the solver knows
  Ending ending_ = Ending::kNone;
  StopSignal never_;
  TracingTimes times_;
  std::size_t synced_pass_ = 0;
  std::uint64_t solutions_ = 0;
};

}  // namespace solitaire
