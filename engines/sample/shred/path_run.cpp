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
std::optional<double> PathRun::propose(const Kernel& from, ChoiceNumber picked, const Proposal& proposal,
                                       const Passage& passage) {
  Kernel& to = passage.to->kernel;
  const Kernel::Outcome outcome = follow(to, [&](ChoiceNumber choice) -> std::optional<Scalar> {
    const ChoiceNumber origin = passage.origins[choice];
    if (origin == Passage::kNew) return std::nullopt;
    return origin == picked ? proposal.value.scalar() : from.value(origin);
  });
  if (outcome == Kernel::Outcome::kLeavesTrace) return std::nullopt;
  if (outcome == Kernel::Outcome::kImpossible) return -HUGE_VAL;
  double forgotten = 0;
  for (const ChoiceNumber each : passage.forgotten) forgotten += log_prior(from, each);
  const auto count = static_cast<double>(from.program().choices.size());
  const auto proposed_count = static_cast<double>(to.program().choices.size());
  return to.log_score() - from.log_score() + proposal.log_ratio + forgotten - drawn_density_ +
         std::log(count) - std::log(proposed_count);
}

std::optional<double> PathRun::restart(Kernel& to) {
  const Kernel::Outcome outcome =
      follow(to, [](ChoiceNumber) -> std::optional<Scalar> { return std::nullopt; });
  if (outcome == Kernel::Outcome::kLeavesTrace) return std::nullopt;
  return outcome == Kernel::Outcome::kScored ? to.log_score() - drawn_density_ : -HUGE_VAL;
}

}  // namespace solitaire
