#pragma once
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "engines/sample/chain.h"
#include "engines/sample/joint_move.h"
#include "engines/sample/rerun.h"
#include "engines/sample/restarts.h"
#include "engines/sample/slice_sampler.h"
#include "engines/sample/traced_structure.h"

namespace solitaire {

/// Metropolis-Hastings on the trace (chapter 3 of the dissertation). A step changes one choice and computes
/// anew what depends on it, by straight-line code, and no more of the program. Where the density has a known
/// form along the choice, the new value is drawn from its distribution given all others, and taken for sure.
///
/// A step that would take another path of the program is made by running it again, as the lightweight engine
/// does. The path that it comes to is traced once and kept. What is proposed, and with which probability it
/// is taken, depends on neither, so the chain is the same whatever is traced already.
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
  std::optional<Diagnostic> slowed_by() const override { return slowed_by_; }

  /// The present state; its value is that of the last time that the program was run.
  const SampledState& state() {
    if (structure_ != nullptr) fetch_state();
    return state_;
  }
  AddressTable& addresses() { return rerun_.addresses(); }

 private:
  void scan();
  bool keeps_path(ChoiceNumber choice) const;
  void step();
  void restart();
  void move_jointly();
  JointMove* find_joint_move();
  bool step_by_form(ChoiceNumber choice);
  void step_by_proposal(ChoiceNumber choice);
  bool moves_with_others(ChoiceNumber choice) const;
  void step_by_rerun(ChoiceNumber choice, const Proposal& proposal);
  void change(ChoiceNumber choice, Scalar value, Move move);
  void learn(AddressId address, const Proposal& proposal, double log_ratio);
  bool accepts(double log_ratio) { return std::log(stream_.uniform()) < log_ratio; }
  std::size_t choices() const;
  void fetch_state();
  void enter();
  TracedStructure* find();
  void check_density() const;

  const Program& program_;
  const ParamValues& params_;
  Limits limits_;
  ReturnedNumbers returned_;
  RandomStream stream_;
  Rerun rerun_;
  Proposer proposer_;
  SliceSampler slice_sampler_;
  /// The present state: its values are the kernel's where there is one, and these are of the last time that
  /// the program was run.
  SampledState state_;
  SampledState proposed_;
  TracedStructure* structure_ = nullptr;  // that the present state takes, unless it cannot be traced
  std::vector<std::unique_ptr<TracedStructure>> structures_;
  std::optional<Diagnostic> slowed_by_;
  std::size_t steps_in_sweep_ = 1;  // the most choices that a state of the warm-up had
  /// Of the floats at these addresses, for those that were met in the warm-up.
  std::map<std::vector<std::uint32_t>, JointMove> joint_moves_;
  JointMove* joint_move_ = nullptr;  // of the structure, if it has one
  Restarts restarts_;
  bool warming_up_ = true;
  MoveTally moves_;
};

}  // namespace solitaire
