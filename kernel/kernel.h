#pragma once
#include <bit>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "kernel/compiler.h"
#include "kernel/score_program.h"
#include "kernel/slice.h"
#include "kernel/stages.h"
#include "kernel/upkeep.h"

namespace solitaire {

/// By which two values of one type are the same; of floats also where they are NaN.
inline std::int64_t bits_of(Scalar value) { return std::bit_cast<std::int64_t>(value); }

/// The number of a choice in a ScoreProgram.
using ChoiceNumber = std::size_t;

/// A ScoreProgram at work: values of its choices, with the density that they have, and what becomes of the
/// density when one of them changes.
///
/// Where the form of the density along a choice is known, its numbers() say how to draw a value, and set()
/// takes it over. So do block_numbers() and set_block() for floats whose form is known together. None of them
/// computes a density: what only a density needs is left behind until refresh(). All functions that need it
/// say so, but for proposals, which see to it themselves.
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
  const Upkeep& upkeep() const { return upkeep_; }

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
    bool stale = false, underived = false;
  };
  void keep(Present& present) const;
  void come_back(const Present& present);
  /// What a change of one choice would do. The present values stay until accept() takes the change over. Of a
  /// choice with finitely many values, the same in all executions, it is one of these.
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
  /// The values of all choices where it was, when a choice or all floats had another value, for the first
  /// such time since this was asked for.
  std::optional<std::vector<Scalar>> take_infinite() { return std::exchange(infinite_, std::nullopt); }
  /// Takes over the change that was proposed last, which has to have been scored.
  void accept();

  /// The numbers of the form along a choice, whose form is known. Weights are finite or minus infinity.
  std::span<const double> numbers(ChoiceNumber choice);
  /// Gives a choice whose form is known another value, unless that breaks a condition; then it returns false
  /// and changes nothing. A value of a form with weights is one whose weight is finite.
  bool set(ChoiceNumber choice, Scalar value);
  /// How the density's logarithm is curved along the floats of the program's block: the second derivatives,
  /// whose signs are turned, row by row up to the diagonal; and then its slopes at the present point.
  std::span<const double> block_numbers();
  /// set() of all floats of the block.
  bool set_block(std::span<const double> values);
  /// Computes what these have left behind.
  void refresh();

  /// The logarithm of the present density; needs refresh(). Differences are added up, so it is computed anew
  /// now and then.
  double log_score() const { return log_score_; }
  Scalar value(ChoiceNumber choice) const {
    const ScoreProgram::Choice& at = program_.choices[choice];
    return at.cell == kNoCell ? at.only_value : cells_[at.cell];
  }
  /// The choice's distribution with the present values of its parameters.
  Distribution distribution(ChoiceNumber choice) const;
  /// The same without weights, which is all that its values follow from, and takes less time. It stands until
  /// this is called another time.
  const Distribution& domain(ChoiceNumber choice);
  /// The values of the program's outputs under the present choices.
  std::vector<double> outputs();

 private:
  /// Code that a machine runs, once it is worth being compiled.
  struct Compiled {
    Compiler::Code code;
    std::uint32_t runs = 0;
  };

  void read_parameters(ChoiceNumber choice, Distribution& distribution) const;
  bool reach(std::size_t stage);
  Outcome score_all();
  Outcome score_slice(std::size_t slice);
  Outcome outcome_of(double log_density);
  bool run_code(std::span<const Instruction> code, Compiled& compiled);
  bool holds(Cell cell) const { return cells_[cell].i != 0; }
  void differentiate();
  void derive();
  bool has_drifted();
  bool change(ChoiceNumber choice, Scalar value);
  bool change_block(std::span<const double> values);
  std::vector<Scalar> values() const;
  void note_infinity(std::size_t slice);
  void note_infinity(ChoiceNumber choice, Scalar value);

  ScoreProgram program_;
  std::vector<ChoiceNumber> floats_;  // that can change
  std::vector<Stage> stages_;
  std::vector<Slice> slices_;
  Upkeep upkeep_;
  std::vector<Cell> slopes_;  // once they are asked for
  bool compiles_;
  Compiler compiler_;
  std::vector<Compiled> compiled_stages_, compiled_slices_;
  std::vector<Compiled> compiled_forms_, compiled_changes_, compiled_accepted_;
  Compiled compiled_all_, compiled_derived_, compiled_outputs_, compiled_block_form_, compiled_block_change_;
  std::vector<Distribution> domains_;  // of the choices, as they were asked for last; those that are fixed
  std::vector<Scalar> cells_;          // the program's, and behind them room for the longest slice

  std::vector<double> numbers_;       // that were asked for last
  std::vector<double> former_block_;  // of set_block(), to put back
  bool stale_ = false;                // whether set() has left something behind
  bool underived_ = true;             // whether the kept cells of forms are to be made anew

  std::size_t proposed_ = 0;  // the number of a slice
  std::optional<std::int64_t>
      proposed_bits_;  // of the value that was proposed last, unless all has changed since
  Outcome outcome_ = Outcome::kScored;
  double difference_ = 0;
  double log_score_ = 0;
  double largest_score_ = 0;  // in size, since it was computed anew
  std::uint64_t accepted_ = 0;
  std::uint64_t infinities_ = 0;
  std::optional<std::vector<Scalar>> infinite_;
};

}  // namespace solitaire
