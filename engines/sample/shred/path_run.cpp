#include "engines/sample/shred/path_run.h"

#include <cmath>
#include <functional>

namespace solitaire {

/// `known` gives the value of a choice, or nothing where it is drawn. One that the choice cannot have here
/// makes the execution impossible, wherever it leads.
template <class Known>
Kernel::Outcome PathRun::follow(Kernel& to, Known known) {
  drawn_density_ = 0;
  bool possible = true;
  const auto answer = [&](ChoiceNumber choice) {
    if (const std::optional<Scalar> value = known(choice)) {
      const Distribution& domain = to.domain(choice);
      possible = possible && domain.contains(TypedScalar(domain.type(), *value));
      return *value;
    }
    const Distribution distribution = to.distribution(choice);
    const TypedScalar drawn = fresh_.draw(to.program().choices[choice].address, distribution);
    drawn_density_ += distribution.log_density(drawn);
    return drawn.scalar();
  };
  const Kernel::Outcome outcome = to.follow(std::cref(answer));
  return possible ? outcome : Kernel::Outcome::kImpossible;
}

/// The ratio is that of Rerun::propose().
std::optional<double> PathRun::propose(TracedStructure& start, ChoiceNumber picked, const Proposal& proposal,
                                       const Passage& passage) {
  const Kernel& from = start.kernel;
  Kernel& to = passage.to->kernel;
  const Kernel::Outcome outcome = follow(to, [&](ChoiceNumber choice) -> std::optional<Scalar> {
    const ChoiceNumber origin = passage.origins[choice];
    if (origin == Passage::kNew) return std::nullopt;
    return origin == picked ? proposal.value.scalar() : from.value(origin);
  });
  if (outcome == Kernel::Outcome::kLeavesTrace) return std::nullopt;
  if (outcome == Kernel::Outcome::kImpossible) return -HUGE_VAL;
  const auto count = static_cast<double>(from.program().choices.size());
  const auto proposed_count = static_cast<double>(to.program().choices.size());
  const double log_picks = proposal.log_ratio + std::log(count) - std::log(proposed_count);
  if (passage.draws_block) return draw_block(start, *passage.to) + log_picks;
  double forgotten = 0;
  for (const ChoiceNumber each : passage.forgotten) forgotten += log_prior(from, each);
  return to.log_score() - from.log_score() + forgotten - drawn_density_ + log_picks;
}

/// Draws the block of the execution that was followed, whatever its floats were there. Returns the logarithm
/// of the ratio of the densities of the rest, for all values of the floats together: a density over that of
/// its block, given the rest, is that of the rest.
double PathRun::draw_block(TracedStructure& from, TracedStructure& to) {
  if (!from.block.look(from.kernel) || !to.block.look(to.kernel)) return -HUGE_VAL;
  const double log_ratio =
      to.kernel.log_score() - to.block.log_density() - (from.kernel.log_score() - from.block.log_density());
  return to.kernel.set_block(to.block.draw(stream_)) ? log_ratio : -HUGE_VAL;
}

std::optional<double> PathRun::restart(Kernel& to) {
  const Kernel::Outcome outcome =
      follow(to, [](ChoiceNumber) -> std::optional<Scalar> { return std::nullopt; });
  if (outcome == Kernel::Outcome::kLeavesTrace) return std::nullopt;
  return outcome == Kernel::Outcome::kScored ? to.log_score() - drawn_density_ : -HUGE_VAL;
}

}  // namespace solitaire
