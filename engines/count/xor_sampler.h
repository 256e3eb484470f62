#pragma once
#include <cmath>

#include "base/random.h"
#include "engines/count/solution_space.h"

namespace solitaire {

/// So many random parities: each bit takes part in each with probability 1/2. They cut the models of a space
/// into cells; any three models lie in theirs independently of each other (Gomes, Sabharwal and Selman,
/// "Near-Uniform Sampling of Combinatorial Spaces Using XOR Constraints", 2006).
std::vector<XorConstraint> random_parities(RandomStream& random, std::size_t bits, std::size_t count);

/// Returns how many parities make cells of about 5 to 10 models: the average is more than kMostInCell with a
/// probability of at most 1 - confidence. Throws Interrupted.
std::uint32_t parities_for_cells(SpacePart& part, double confidence, RandomStream& random,
                                 const StopSignal& stop);
constexpr double kMostInCell = 18;

/// Draws models of a part nearly uniformly, each independently of those before.
///
/// A draw takes a random cell and one of kSlots numbers; if the cell has at most kSlots models, then the
/// model of that number in it, and if there is none, it tries another cell. So every model is drawn with the
/// same probability but for how often its cell is overfull. This is the scheme of Bellare, Goldreich and
/// Petrank ("Uniform Generation of NP-Witnesses Using an NP-Oracle", 2000) with the hash functions of UniGen
/// (Chakraborty, Fremont, Meel, Seshia and Vardi, "On Parallel Scalable Uniform SAT Witness Generation",
/// 2015), whose bound, a factor of 1 + 6.84, is looser.
///
/// The other models in a model's cell are m <= kMostInCell on the average, with a variance of at most m, as
/// any three models lie in cells independently. By Cantelli's inequality they are kSlots or more with a
/// probability of at most m / (m + (kSlots - m)^2) < 0.085. So each model's probability is within a factor
/// of 1.1 of 1 / number of models.
class CellSampler {
 public:
  static constexpr std::size_t kSlots = 32;
  /// The probability, over seeds, that the number of parities is such that the factor holds.
  static constexpr double kConfidence = 0.95;

  /// Throws Interrupted.
  CellSampler(SpacePart& part, RandomStream random, const StopSignal& stop);
  /// Depends on the stream alone. Throws Interrupted.
  BitModel draw(RandomStream& random, const StopSignal& stop);
  /// About how many models there are: a guess.
  double guessed_models() const { return std::exp2(parities_ + 3.0); }

 private:
  SpacePart& part_;
  std::uint32_t parities_;
};

}  // namespace solitaire
