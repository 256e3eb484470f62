#include "kernel/kernel.h"

#include <algorithm>
#include <cmath>

#include "kernel/gradient.h"
#include "kernel/machine.h"

namespace solitaire {
namespace {

/// After so many changes the score is computed anew: rounding lets a running sum drift, by 1e-11 in a million
/// steps.
constexpr std::uint64_t kRescoreEvery = std::uint64_t{1} << 20;

/// To compile a slice takes as long as some hundred runs of it.
constexpr std::uint32_t kCompiledAfter = 300;

/// A bool is an int of 0 or 1.
double number(Scalar value, Type type) {
  return type == Type::kFloat ? value.f : static_cast<double>(value.i);
}

}  // namespace

Kernel::Kernel(ScoreProgram program, bool compiles)
    : program_(std::move(program)),
      slices_(slices_of(program_)),
      compiles_(compiles),
      compiled_(slices_.size()) {
  std::size_t longest = 0;
  for (const Slice& slice : slices_) longest = std::max(longest, slice.code.size());
  for (ChoiceNumber i = 0; i < program_.choices.size(); ++i) {
    const Cell cell = program_.choices[i].cell;
    if (cell != kNoCell && program_.types[cell] == Type::kFloat) floats_.push_back(i);
  }
  cells_ = program_.cells;
  cells_.resize(program_.cells.size() + longest + std::max<std::size_t>(1, floats_.size()));
}

Kernel::Outcome Kernel::load(const std::vector<Scalar>& values) {
  for (ChoiceNumber i = 0; i < program_.choices.size(); ++i)
    if (program_.choices[i].cell != kNoCell) cells_[program_.choices[i].cell] = values[i];
  proposed_bits_.reset();
  return score_all();
}

Kernel::Outcome Kernel::score_all() {
  const bool made = run(program_.code, cells_.data());
  const auto holds = [&](Cell cell) { return cells_[cell].i != 0; };
  if (!made || !std::all_of(program_.assumed.begin(), program_.assumed.end(), holds))
    return Outcome::kLeavesTrace;
  if (!std::all_of(program_.required.begin(), program_.required.end(), holds)) return Outcome::kImpossible;
  log_score_ = program_.constant;
  for (const Cell term : program_.terms) log_score_ += cells_[term].f;
  if (std::isnan(log_score_)) return Outcome::kLeavesTrace;
  return log_score_ > -HUGE_VAL ? Outcome::kScored : Outcome::kImpossible;
}

/// What was proposed last stands in the slice's cells still, so to propose it again takes no time.
Kernel::Outcome Kernel::propose(ChoiceNumber choice, Scalar value) {
  if (proposed_ == choice && proposed_bits_ == bits_of(value)) return outcome_;
  proposed_ = choice;
  proposed_bits_ = bits_of(value);
  cells_[program_.cells.size()] = value;
  return outcome_ = score_slice(choice);
}

/// Both machines give the same, so it does not matter when the faster one takes over.
bool Kernel::run_slice(std::size_t slice) {
  Compiled& compiled = compiled_[slice];
  if (compiled.code != nullptr) return compiled.code(cells_.data());
  if (compiles_ && ++compiled.runs == kCompiledAfter) compiled.code = compiler_.compile(slices_[slice].code);
  return run(slices_[slice].code, cells_.data());
}

void Kernel::differentiate() {
  Slice& slice = slices_.back();
  slopes_ = add_gradient(program_, floats_.size(), slice);
  cells_.resize(std::max(cells_.size(), program_.cells.size() + floats_.size() + slice.code.size()));
}

Kernel::Outcome Kernel::propose_floats(std::span<const double> values) {
  if (slopes_.empty()) differentiate();
  proposed_ = slices_.size() - 1;
  proposed_bits_.reset();
  for (std::size_t i = 0; i < values.size(); ++i) cells_[program_.cells.size() + i] = Scalar::of(values[i]);
  return outcome_ = score_slice(proposed_);
}

Kernel::Outcome Kernel::score_slice(std::size_t number) {
  const Slice& slice = slices_[number];
  const bool made = run_slice(number);
  const auto holds = [&](Cell cell) { return cells_[cell].i != 0; };
  if (!made || !std::all_of(slice.assumed.begin(), slice.assumed.end(), holds)) return Outcome::kLeavesTrace;
  if (!std::all_of(slice.required.begin(), slice.required.end(), holds)) return Outcome::kImpossible;
  difference_ = slice.difference == kNoCell ? 0 : cells_[slice.difference].f;
  if (std::isnan(difference_)) return Outcome::kLeavesTrace;
  return difference_ > -HUGE_VAL ? Outcome::kScored : Outcome::kImpossible;
}

void Kernel::accept() {
  for (const auto& [present, proposed] : slices_[proposed_].commits) cells_[present] = cells_[proposed];
  log_score_ += difference_;
  proposed_bits_.reset();
  if (++accepted_ % kRescoreEvery == 0) score_all();
}

Scalar Kernel::value(ChoiceNumber choice) const {
  const ScoreProgram::Choice& at = program_.choices[choice];
  return at.cell == kNoCell ? at.only_value : cells_[at.cell];
}

Distribution Kernel::domain(ChoiceNumber choice) const {
  const ScoreProgram::Choice& at = program_.choices[choice];
  Distribution made{at.distribution.lo, at.distribution.hi, at.distribution.step, at.distribution.family};
  const auto parameter = [&](std::size_t i) { return cells_[at.parameters[i]]; };
  if (!at.distribution.weights.empty()) return made;
  if (made.family == Distribution::Family::kRange || made.family == Distribution::Family::kIndex) {
    made.lo = parameter(0).i;
    made.step = parameter(2).i;
    made.hi = parameter(1).i - (parameter(1).i - made.lo) % made.step;
  } else {
    made.a = parameter(0).f;
    if (at.parameters.size() > 1) made.b = parameter(1).f;
  }
  return made;
}

Distribution Kernel::distribution(ChoiceNumber choice) const {
  Distribution made = domain(choice);
  const ScoreProgram::Choice& at = program_.choices[choice];
  if (at.distribution.weights.empty()) return made;
  std::vector<double> weights;
  for (const Cell parameter : at.parameters) weights.push_back(cells_[parameter].f);
  made.weights = Weights(std::move(weights));
  return made;
}

std::vector<double> Kernel::outputs() {
  run(program_.output_code, cells_.data());
  std::vector<double> values;
  for (const Cell cell : program_.outputs) values.push_back(number(cells_[cell], program_.types[cell]));
  return values;
}

}  // namespace solitaire
