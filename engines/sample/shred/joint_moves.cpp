#include "engines/sample/shred/joint_moves.h"

namespace solitaire {

/// Structures that are met after the warm-up have none, since nothing learns how long its steps are.
void JointMoves::enter(const TracedStructure* structure) {
  present_ = nullptr;
  if (structure == nullptr || structure->kernel.floats().size() < 2) return;
  std::vector<std::uint32_t> addresses;
  bool has_unknown = false;
  for (const ChoiceNumber each : structure->kernel.floats()) {
    const ScoreProgram::Choice& choice = structure->kernel.program().choices[each];
    addresses.push_back(choice.address.index);
    has_unknown = has_unknown || choice.form == Form::kUnknown;
  }
  auto found = moves_of_.find(addresses);
  if (found == moves_of_.end() && warming_up_)
    found = moves_of_.try_emplace(addresses, addresses.size(), has_unknown).first;
  if (found != moves_of_.end()) present_ = &found->second;
}

void JointMoves::move(Kernel& kernel) {
  if (present_ == nullptr) return;
  if (warming_up_) present_->watch_single_moves(kernel);
  if (present_->ready()) {
    const JointMove::Result result = present_->move(kernel, stream_, warming_up_);
    moves_.add(Move::kJoint, result.moved);
    if (result.diverged) moves_.add(Trouble::kDivergence);
  }
  if (warming_up_) present_->watch(kernel);
}

void JointMoves::end_warmup() {
  warming_up_ = false;
  for (auto& [addresses, move] : moves_of_) move.end_warmup();
}

}  // namespace solitaire
