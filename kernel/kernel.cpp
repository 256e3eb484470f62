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
/// So it is where it has become so many times smaller, as on the way from a start far away: rounding was as
/// large as the score was.
constexpr double kMostShrunk = 1000;

/// To compile code takes as long as some hundred runs of it.
constexpr std::uint32_t kCompiledAfter = 300;

/// A bool is an int of 0 or 1.
double number(Scalar value, Type type) {
  return type == Type::kFloat ? value.f : static_cast<double>(value.i);
}

}  // namespace

Kernel::Kernel(ScoreProgram program, bool compiles)
    : program_(std::move(program)),
      stages_(stages_of(program_)),
      slices_(slices_of(program_)),
      upkeep_(upkeep_of(program_, slices_)),
      compiles_(compiles),
      compiled_stages_(stages_.size()),
      compiled_slices_(slices_.size()),
      compiled_forms_(program_.choices.size()),
      compiled_changes_(program_.choices.size()),
      compiled_accepted_(program_.choices.size()) {
  find_commits(program_, upkeep_.kept, slices_);
  std::size_t longest = 0;
  for (const Slice& slice : slices_) longest = std::max(longest, slice.code.size());
  for (ChoiceNumber i = 0; i < program_.choices.size(); ++i) {
    const Cell cell = program_.choices[i].cell;
    if (cell != kNoCell && program_.types[cell] == Type::kFloat) floats_.push_back(i);
  }
  cells_ = program_.cells;
  for (ChoiceNumber i = 0; i < program_.choices.size(); ++i) {
    domains_.push_back(program_.choices[i].distribution);
    domains_.back().weights = {};
    if (program_.choices[i].fixed_parameters) read_parameters(i, domains_.back());
  }
  cells_.resize(program_.cells.size() + longest + std::max<std::size_t>(1, floats_.size()));
}

Kernel::Outcome Kernel::follow(const Answer& answer) {
  proposed_bits_.reset();
  for (ChoiceNumber i = 0; i < program_.choices.size(); ++i) {
    if (!reach(i)) return Outcome::kLeavesTrace;
    const Scalar value = answer(i);
    if (program_.choices[i].cell != kNoCell) cells_[program_.choices[i].cell] = value;
  }
  return reach(program_.choices.size()) ? score_all() : Outcome::kLeavesTrace;
}

/// Computes what a stage adds to the one before it. Returns false if no execution on this path comes there.
bool Kernel::reach(std::size_t stage) {
  const std::size_t start = stage == 0 ? 0 : stages_[stage - 1].code_end;
  const std::span<const Instruction> code(program_.code.data() + start, stages_[stage].code_end - start);
  const std::vector<Cell>& assumed = stages_[stage].assumed;
  const bool made = run_code(code, compiled_stages_[stage]);
  return made && std::all_of(assumed.begin(), assumed.end(), [&](Cell cell) { return holds(cell); });
}

Kernel::Outcome Kernel::load(const std::vector<Scalar>& values) {
  proposed_bits_.reset();
  for (ChoiceNumber i = 0; i < program_.choices.size(); ++i)
    if (program_.choices[i].cell != kNoCell) cells_[program_.choices[i].cell] = values[i];
  const bool made = run_code(program_.code, compiled_all_);
  const bool on_path = made && std::all_of(program_.assumed.begin(), program_.assumed.end(),
                                           [this](Cell cell) { return cells_[cell].i != 0; });
  return on_path ? score_all() : Outcome::kLeavesTrace;
}

void Kernel::keep(Present& present) const {
  present.cells.assign(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(program_.cells.size()));
  present.log_score = log_score_;
  present.stale = stale_;
  present.underived = underived_;
}

void Kernel::come_back(const Present& present) {
  std::copy(present.cells.begin(), present.cells.end(), cells_.begin());
  log_score_ = present.log_score;
  stale_ = present.stale;
  underived_ = present.underived;
  proposed_bits_.reset();
}

/// Sums up what the code of the program made.
Kernel::Outcome Kernel::score_all() {
  stale_ = false;
  underived_ = true;
  if (!std::all_of(program_.required.begin(), program_.required.end(),
                   [&](Cell cell) { return holds(cell); }))
    return Outcome::kImpossible;
  log_score_ = program_.constant;
  for (const Cell term : program_.terms) log_score_ += cells_[term].f;
  largest_score_ = std::abs(log_score_);
  const Outcome outcome = outcome_of(log_score_);
  return log_score_ == HUGE_VAL ? Outcome::kLeavesTrace : outcome;  // a run says where
}

Kernel::Outcome Kernel::outcome_of(double log_density) {
  if (std::isnan(log_density)) return Outcome::kLeavesTrace;
  if (log_density == HUGE_VAL) ++infinities_;
  return std::isinf(log_density) ? Outcome::kImpossible : Outcome::kScored;
}

/// What was proposed last stands in the slice's cells still, so to propose it again takes no time.
Kernel::Outcome Kernel::propose(ChoiceNumber choice, Scalar value) {
  if (proposed_ == choice && proposed_bits_ == bits_of(value)) return outcome_;
  if (stale_ && program_.choices[choice].form != Form::kUnknown) refresh();
  proposed_ = choice;
  proposed_bits_ = bits_of(value);
  cells_[program_.cells.size()] = value;
  return outcome_ = score_slice(choice);
}

/// Both machines give the same, so it does not matter when the faster one takes over.
bool Kernel::run_code(std::span<const Instruction> code, Compiled& compiled) {
  if (compiled.code) return compiled.code(cells_.data());
  if (compiles_ && !code.empty() && ++compiled.runs == kCompiledAfter)
    compiled.code = compiler_.compile(code, static_cast<Cell>(program_.cells.size()));
  return run(code, cells_.data());
}

void Kernel::differentiate() {
  Slice& slice = slices_.back();
  slopes_ = add_gradient(program_, floats_.size(), slice);
  find_lasting(slopes_, slice);
  cells_.resize(std::max(cells_.size(), program_.cells.size() + floats_.size() + slice.code.size()));
}

Kernel::Outcome Kernel::propose_floats(std::span<const double> values) {
  if (slopes_.empty()) differentiate();
  refresh();
  proposed_ = slices_.size() - 1;
  proposed_bits_.reset();
  for (std::size_t i = 0; i < values.size(); ++i) cells_[program_.cells.size() + i] = Scalar::of(values[i]);
  return outcome_ = score_slice(proposed_);
}

Kernel::Outcome Kernel::score_slice(std::size_t number) {
  const Slice& slice = slices_[number];
  const bool made = run_code(slice.code, compiled_slices_[number]);
  const auto is_true = [&](Cell cell) { return holds(cell); };
  if (!made || !std::all_of(slice.assumed.begin(), slice.assumed.end(), is_true))
    return Outcome::kLeavesTrace;
  if (!std::all_of(slice.required.begin(), slice.required.end(), is_true)) return Outcome::kImpossible;
  difference_ = slice.difference == kNoCell ? 0 : cells_[slice.difference].f;
  if (difference_ == HUGE_VAL) note_infinity(number);
  return outcome_of(difference_);
}

std::vector<Scalar> Kernel::values() const {
  std::vector<Scalar> values;
  for (ChoiceNumber i = 0; i < program_.choices.size(); ++i) values.push_back(value(i));
  return values;
}

/// The slice has the values that were proposed.
void Kernel::note_infinity(std::size_t slice) {
  if (slice < program_.choices.size()) return note_infinity(slice, cells_[program_.cells.size()]);
  if (infinite_) return;
  infinite_ = values();
  for (std::size_t i = 0; i < floats_.size(); ++i)
    (*infinite_)[floats_[i]] = cells_[program_.cells.size() + i];
}

void Kernel::note_infinity(ChoiceNumber choice, Scalar value) {
  if (infinite_) return;
  infinite_ = values();
  (*infinite_)[choice] = value;
}

void Kernel::accept() {
  for (const auto& [present, proposed] : slices_[proposed_].commits) cells_[present] = cells_[proposed];
  log_score_ += difference_;
  proposed_bits_.reset();
  if (proposed_ == program_.choices.size()) underived_ = true;
  if (!underived_) run_code(upkeep_.accepted[proposed_], compiled_accepted_[proposed_]);
  if (has_drifted()) follow([this](ChoiceNumber choice) { return value(choice); });
}

bool Kernel::has_drifted() {
  const double size = std::abs(log_score_);
  largest_score_ = std::max(largest_score_, size);
  return ++accepted_ % kRescoreEvery == 0 || largest_score_ > kMostShrunk * (1 + size);
}

std::span<const double> Kernel::numbers(ChoiceNumber choice) {
  if (underived_) derive();
  run_code(upkeep_.forms[choice], compiled_forms_[choice]);
  const ScoreProgram::Choice& at = program_.choices[choice];
  numbers_.clear();
  for (const Cell cell : at.numbers) {
    double number = cells_[cell].f;
    if (at.form == Form::kWeights && !std::isfinite(number)) {
      if (number == HUGE_VAL) {
        ++infinities_;
        note_infinity(choice, Scalar::of(at.distribution.value(numbers_.size())));
      }
      number = -HUGE_VAL;
    }
    numbers_.push_back(number);
  }
  return numbers_;
}

bool Kernel::set(ChoiceNumber choice, Scalar value) {
  if (underived_) derive();
  const Scalar before = cells_[program_.choices[choice].cell];
  proposed_bits_.reset();
  stale_ = true;
  if (change(choice, value)) return true;
  change(choice, before);
  return false;
}

bool Kernel::change(ChoiceNumber choice, Scalar value) {
  const ScoreProgram::Choice& at = program_.choices[choice];
  cells_[at.cell] = value;
  const bool made = run_code(upkeep_.changes[choice], compiled_changes_[choice]);
  return made && std::all_of(at.required.begin(), at.required.end(), [&](Cell cell) { return holds(cell); });
}

std::span<const double> Kernel::block_numbers() {
  if (underived_) derive();
  run_code(upkeep_.block_form, compiled_block_form_);
  const ScoreProgram::Block& block = program_.block;
  const auto number_of = [&](std::size_t i, std::size_t number) {
    return cells_[program_.choices[block.choices[i]].numbers[number]].f;
  };
  numbers_.clear();
  auto mixed = block.mixed.begin();
  for (std::size_t i = 0; i < block.choices.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) numbers_.push_back(-cells_[*mixed++].f);
    numbers_.push_back(-2 * number_of(i, 1));
  }
  for (std::size_t i = 0; i < block.choices.size(); ++i)
    numbers_.push_back(number_of(i, 0) + 2 * number_of(i, 1) * value(block.choices[i]).f);
  return numbers_;
}

bool Kernel::set_block(std::span<const double> values) {
  if (underived_) derive();
  former_block_.clear();
  for (const ChoiceNumber each : program_.block.choices) former_block_.push_back(value(each).f);
  proposed_bits_.reset();
  stale_ = true;
  if (change_block(values)) return true;
  change_block(former_block_);
  return false;
}

bool Kernel::change_block(std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    cells_[program_.choices[program_.block.choices[i]].cell] = Scalar::of(values[i]);
  return run_code(upkeep_.block_change, compiled_block_change_);
}

void Kernel::refresh() {
  if (!stale_) return;
  run_code(program_.code, compiled_all_);
  const bool underived = underived_;
  score_all();
  underived_ = underived;
}

void Kernel::derive() {
  run_code(upkeep_.derived, compiled_derived_);
  underived_ = false;
}

void Kernel::read_parameters(ChoiceNumber choice, Distribution& distribution) const {
  const ScoreProgram::Choice& at = program_.choices[choice];
  if (!at.distribution.weights.empty()) return;
  const auto parameter = [&](std::size_t i) { return cells_[at.parameters[i]]; };
  if (distribution.family == Distribution::Family::kRange ||
      distribution.family == Distribution::Family::kIndex) {
    distribution.lo = parameter(0).i;
    distribution.step = parameter(2).i;
    distribution.hi = parameter(1).i - (parameter(1).i - distribution.lo) % distribution.step;
  } else {
    distribution.a = parameter(0).f;
    if (at.parameters.size() > 1) distribution.b = parameter(1).f;
  }
}

const Distribution& Kernel::domain(ChoiceNumber choice) {
  if (!program_.choices[choice].fixed_parameters) read_parameters(choice, domains_[choice]);
  return domains_[choice];
}

Distribution Kernel::distribution(ChoiceNumber choice) const {
  Distribution made = domains_[choice];
  read_parameters(choice, made);
  const ScoreProgram::Choice& at = program_.choices[choice];
  if (at.distribution.weights.empty()) return made;
  std::vector<double> weights;
  for (const Cell parameter : at.parameters) weights.push_back(cells_[parameter].f);
  made.weights = Weights(std::move(weights));
  return made;
}

std::vector<double> Kernel::outputs() {
  if (underived_) derive();
  run_code(upkeep_.outputs, compiled_outputs_);
  std::vector<double> values;
  for (const Cell cell : program_.outputs) values.push_back(number(cells_[cell], program_.types[cell]));
  return values;
}

}  // namespace solitaire
