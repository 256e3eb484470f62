#pragma once
#include <cmath>
#include <optional>

#include "engines/sample/chain.h"
#include "engines/sample/rerun.h"
#include "engines/sample/restarts.h"
#include "engines/sample/shred/joint_moves.h"
#include "engines/sample/shred/known_paths.h"
#include "engines/sample/shred/path_moves.h"
#include "engines/sample/shred/path_run.h"

namespace solitaire {

/// Metropolis-Hastings on the trace (chapter 3 of the dissertation). A step changes one choice and computes
/// anew what depends on it, by straight-line code, and no more of the program. Where the density has a known
/// form along the choice, the new value is drawn from its distribution given all others, and taken for sure.
///
/// A step that would take another path of the program is tried on the paths that such steps led to before,
/// and is else made by running the program again, as the lightweight engine does. The path that it comes to
/// is traced once and kept. What is proposed, and with which probability it is taken, depends on none of
/// that, so the chain is the same whatever is traced already.
class ShredChain : public Chain {
 public:
  /// As of LightweightChain.
  ShredChain(const Program& program, const ParamValues& params, const Limits& limits, std::uint64_t seed,
             std::uint64_t number, Restarts restarts = Restarts());

  void sweep() override;
  void end_warmup() override;
  void read(const ReturnedNumbers& returned, std::vector<std::string>& names,
            std::vector<double>& numbers) override;
  MoveCounts moves() const override { return moves_.named(); }
  Troubles troubles() const override;
  std::optional<Diagnostic> slowed_by() const override { return known_paths_.refused(); }

  /// The present state; its value is that of the last time that the program was run.
  const SampledState& state() {
    fetch_state();
    return state_;
  }
  AddressTable& addresses() { return rerun_.addresses(); }

 private:
  void step();
  void step_on_trace(ChoiceNumber choice);
  bool step_through(const Passage& passage, ChoiceNumber choice, const Proposal& proposal);
  void leave_path(ChoiceNumber choice, const Proposal& proposal);
  void step_by_rerun(ChoiceNumber choice, const Proposal& proposal);
  void foresee(ChoiceNumber choice);
  static void note_passage(TracedStructure* from, ChoiceNumber choice, TracedStructure* to);
  void restart();
  std::optional<bool> restart_on_trace(double log_least);
  bool restart_by_rerun(double log_least);
  bool accepts(const Proposal& proposal, double log_ratio, AddressId address);
  std::size_t choices() const;
  void fetch_state();
  void enter(TracedStructure* structure);
  void enter_proposed();
  void compare_with_run();
  void look_at_infinity();

  RandomStream stream_;
  Rerun rerun_;
  Proposer proposer_;
  MoveTally moves_;
  PathMoves path_moves_;
  JointMoves joint_moves_;
  KnownPaths known_paths_;
  PathRun path_run_;
  TracedStructure* structure_ = nullptr;  // that the present state takes, unless it cannot be traced
  /// The present state: its values are the structure's where there is one, and these are of the last time
  /// that they were fetched.
  SampledState state_;
  SampledState proposed_;
  Kernel::Present kept_;
  Restarts restarts_;
  std::size_t steps_in_sweep_ = 1;  // the most choices that a state of the warm-up had
  std::uint64_t sweeps_ = 0;
  std::uint64_t foreseeable_ = 0;  // refused steps to paths by running the program
  bool warming_up_ = true;
};

}  // namespace solitaire
