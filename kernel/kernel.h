#pragma once
#include <bit>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "kernel/compiler.h"
#include "kernel/score_program.h"
#include "kernel/slice.h"
#include "kernel/stages.h"

namespace solitaire {

/// By which two values of one type are the same; of floats also where they are NaN.
inline std::int64_t bits_of(Scalar value) { return std::bit_cast<std::int64_t>(value); }

/// The number of a choice in a ScoreProgram.
using ChoiceNumber = std::size_t;

/// A ScoreProgram at work: values of its choices, with the density that they have, and what becomes of the
/// density when one of them changes.
class Kernel {
 public:
  enum class Outcome : std::uint8_t {
    kScored,       // difference() says how much the logarithm of the density changes
    kImpossible,   // the density is 0
    kLeavesTrace,  // the execution takes another path, or an operation has no value: the program has to be
                   // run
  };

  /// Slices that are used often are compiled, unless that is not wanted; what comes is the same.
  explicit Kernel(ScoreProgram program, bool compiles = true);

  const ScoreProgram& program() const { return program_; }
  const Slice& slice(ChoiceNumber choice) const { return slices_[choice]; }

  /// Runs an execution from its first choice to its last. Each is asked for when it is met, and then has its
  /// present distribution; what comes after a condition of the path that does not hold is not asked for.
  using Answer = std::function<Scalar(ChoiceNumber)>;
  Outcome follow(const Answer& answer);
  /// Sets all choices, each to a value of its type, and computes everything anew.
  Outcome load(const std::vector<Scalar>& values);
  /// The present state, to come back to.
  struct Present {
    std::vector<Scalar> cells;
    double log_score = 0;
  };
  void keep(Present& present) const;
  void come_back(const Present& present);
  /// What a change of one choice would do. The present values stay until accept() takes the change over.
  Outcome propose(ChoiceNumber choice, Scalar value);
  /// The same of a change of all floats together: a value for each of floats().
  Outcome propose_floats(std::span<const double> values);
  /// The slope of the density's logarithm along a float, by its place in floats(), where they were proposed
  /// together. NaN where there is none.
  double slope(std::size_t place) const { return cells_[slopes_[place]].f; }
  const std::vector<ChoiceNumber>& floats() const { return floats_; }
  double difference() const { return difference_; }
  /// How often a density was infinite, which counts as impossible: no distribution has such a value.
  std::uint64_t infinities() const { return infinities_; }
  /// Takes over the change that was proposed last, which has to have been scored.
  void accept();

  /// The logarithm of the present density. Differences are added up, so it is computed anew now and then.
  double log_score() const { return log_score_; }
  Scalar value(ChoiceNumber choice) const;
  /// The choice's distribution with the present values of its parameters.
  Distribution distribution(ChoiceNumber choice) const;
  /// The same without weights, which is all that its values follow from, and takes less time.
  Distribution domain(ChoiceNumber choice) const;
  /// The values of the program's outputs under the present choices.
  std::vector<double> outputs();

 private:
  /// Code that a machine runs, once it is worth being compiled.
  struct Compiled {
    Compiler::Code code = nullptr;
    std::uint32_t runs = 0;
  };

  bool reach(std::size_t stage);
  Outcome score_all();
  Outcome score_slice(std::size_t slice);
  Outcome outcome_of(double log_density);
  bool run_code(std::span<const Instruction> code, Compiled& compiled);
  bool holds(Cell cell) const { return cells_[cell].i != 0; }
  void differentiate();

  ScoreProgram program_;
  std::vector<ChoiceNumber> floats_;  // that can change
  std::vector<Stage> stages_;
  std::vector<Slice> slices_;
  std::vector<Cell> slopes_;  // once they are asked for
  bool compiles_;
  Compiler compiler_;
  std::vector<Compiled> compiled_stages_, compiled_slices_;
  std::vector<Scalar> cells_;  // the program's, and behind them room for the longest slice

  std::size_t proposed_ = 0;  // the number of a slice
  std::optional<std::int64_t>
      proposed_bits_;  // of the value that was proposed last, unless all has changed since
  Outcome outcome_ = Outcome::kScored;
  double difference_ = 0;
  double log_score_ = 0;
  std::uint64_t accepted_ = 0;
  std::uint64_t infinities_ = 0;
};

}  // namespace solitaire
