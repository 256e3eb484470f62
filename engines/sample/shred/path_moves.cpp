#include "engines/sample/shred/path_moves.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "engines/sample/acceptance.h"
#include "engines/sample/shred/conditional.h"
#include "engines/tuning.h"

namespace solitaire {
namespace {

/// Products of some floats up to here, and of their inverses, are floats.
constexpr double kUsual = 1e60;
bool is_usual(double value) { return std::abs(value) < kUsual && std::abs(value) > 1 / kUsual; }

}  // namespace

/// Where no form is known, half of the steps go anywhere, and half to what is about as probable.
void PathMoves::scan(TracedStructure& structure, bool floats_move, bool learns) {
  Kernel& kernel = structure.kernel;
  const ScoreProgram& program = kernel.program();
  const bool together = draw_block(structure);
  for (ChoiceNumber i = 0; i < program.choices.size(); ++i) {
    if (together && program.block.has(i)) continue;
    if (program.choices[i].cell == kNoCell || !structure.keeps_path(i)) continue;
    if (change_by_form(kernel, i)) continue;
    if (stream_.below(2) != 0) {
      change_anywhere(kernel, i);
    } else if (!floats_move || program.types[program.choices[i].cell] != Type::kFloat) {
      change(kernel, i, slice_sampler_.draw(kernel, i, learns), Move::kSlice);
    }
  }
}

/// Draws the floats of the block together. Returns false where there are none, or where they have no such
/// distribution; single floats far from 1 are looked at.
bool PathMoves::draw_block(TracedStructure& structure) {
  if (structure.kernel.program().block.choices.empty() || !structure.block.look(structure.kernel))
    return false;
  const std::span<const double> values = structure.block.draw(stream_);
  if (!std::all_of(values.begin(), values.end(), is_usual)) return false;
  moves_.add(Move::kGibbs, structure.kernel.set_block(values));
  return true;
}

/// Draws the choice from its distribution given all others, if that is known.
bool PathMoves::change_by_form(Kernel& kernel, ChoiceNumber choice) {
  const ScoreProgram::Choice& at = kernel.program().choices[choice];
  if (at.form != Form::kUnknown) {
    const std::optional<Scalar> value = draw_of_form(kernel, choice, stream_);
    if (value) {
      set(kernel, choice, *value);
    } else {
      moves_.add(Trouble::kUnbounded);
    }
    return value.has_value();
  }
  if (!at.distribution.is_finite()) return false;
  const Distribution& distribution = kernel.domain(choice);
  if (distribution.size() > tuning::kMostValuesCompared) return false;
  change(kernel, choice, draw_of_few(kernel, choice, distribution, stream_), Move::kGibbs);
  return true;
}

/// A float far from 1 is looked at before it is taken: the density may not be finite there.
void PathMoves::set(Kernel& kernel, ChoiceNumber choice, Scalar value) {
  const bool is_float = kernel.program().choices[choice].form != Form::kWeights;
  if (is_float && !is_usual(value.f)) return change(kernel, choice, value, Move::kGibbs);
  const bool same = bits_of(value) == bits_of(kernel.value(choice));
  moves_.add(Move::kGibbs, same || kernel.set(choice, value));
}

void PathMoves::change_anywhere(Kernel& kernel, ChoiceNumber choice) {
  const Distribution& distribution = kernel.domain(choice);
  const TypedScalar present(distribution.type(), kernel.value(choice));
  const Proposal proposal = proposer_.anywhere(distribution, present);
  const double uniform = stream_.uniform();
  const bool possible = distribution.contains(proposal.value) &&
                        kernel.propose(choice, proposal.value.scalar()) == Kernel::Outcome::kScored;
  const double log_ratio = possible ? kernel.difference() + proposal.log_ratio : -HUGE_VAL;
  const bool accepted = accepts(log_ratio, uniform);
  moves_.add(proposal.move, accepted);
  if (accepted) kernel.accept();
}

/// A value that other conditions rule out is refused, which is a step of Metropolis's.
void PathMoves::change(Kernel& kernel, ChoiceNumber choice, Scalar value, Move move) {
  if (bits_of(value) == bits_of(kernel.value(choice))) return moves_.add(move, true);
  const bool possible = kernel.propose(choice, value) == Kernel::Outcome::kScored;
  moves_.add(move, possible);
  if (possible) kernel.accept();
}

}  // namespace solitaire
