#include "kernel/slice.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>

#include "kernel/dependents.h"

namespace solitaire {
namespace {

/// What depends on the cells of a program, and the instructions that make them.
struct Users {
  explicit Users(const ScoreProgram& program)
      : dependents(program.cells.size()), maker(program.cells.size()) {
    for (std::uint32_t i = 0; i < program.code.size(); ++i) {
      const Instruction& step = program.code[i];
      for (std::size_t k = 0; k < operation(step.op).arity; ++k)
        dependents.add(step.operands[k], step.result);
      maker[step.result] = i;
    }
  }

  Dependents dependents;
  std::vector<std::uint32_t> maker;
};

/// Where the cells of a slice stand while it runs: kNoCell of a cell that it does not change.
class Proposed {
 public:
  explicit Proposed(std::size_t cells) : at_(cells, kNoCell) {}
  void set(Cell present, Cell proposed) { at_[present] = proposed; }
  Cell operator[](Cell present) const { return at_[present]; }
  Cell read(Cell present) const { return at_[present] == kNoCell ? present : at_[present]; }

 private:
  std::vector<Cell> at_;
};

/// Adds the code that sums up by how much the terms change. Four sums go on side by side, since an addition
/// waits for the one before it.
void sum_up(Slice& slice, Cell first_result) {
  const auto emit = [&](Op op, Cell a, Cell b) {
    const auto result = static_cast<Cell>(first_result + slice.code.size());
    slice.code.push_back({op, result, {a, b, 0}});
    return result;
  };
  std::array<Cell, 4> sums{kNoCell, kNoCell, kNoCell, kNoCell};
  for (std::size_t i = 0; i < slice.terms.size(); ++i) {
    Cell& sum = sums[i % sums.size()];
    const Cell more = emit(Op::kSubFloat, slice.terms[i].proposed, slice.terms[i].present);
    sum = sum == kNoCell ? more : emit(Op::kAddFloat, sum, more);
  }
  for (const Cell sum : sums) {
    if (sum == kNoCell) break;
    slice.difference = slice.difference == kNoCell ? sum : emit(Op::kAddFloat, slice.difference, sum);
  }
}

Slice slice_of(const ScoreProgram& program, std::span<const Cell> choices, Users& users, Proposed& proposed) {
  Slice slice;
  const auto change = [&](Cell present) {
    const auto at = static_cast<Cell>(program.cells.size() + slice.changes.size());
    slice.changes.push_back({present, at});
    proposed.set(present, at);
    return at;
  };
  for (const Cell choice : choices) change(choice);
  for (const Cell made : users.dependents.closure(choices)) {
    Instruction step = program.code[users.maker[made]];
    for (std::size_t k = 0; k < operation(step.op).arity; ++k)
      step.operands[k] = proposed.read(step.operands[k]);
    step.result = change(step.result);
    slice.code.push_back(step);
  }
  for (const Cell term : program.terms)
    if (proposed[term] != kNoCell) slice.terms.push_back({term, proposed[term]});
  for (const Cell cell : program.required)
    if (proposed[cell] != kNoCell) slice.required.push_back(proposed[cell]);
  for (const Cell cell : program.assumed)
    if (proposed[cell] != kNoCell) slice.assumed.push_back(proposed[cell]);
  for (const Slice::Changed& each : slice.changes) proposed.set(each.present, kNoCell);
  sum_up(slice, static_cast<Cell>(program.cells.size() + choices.size()));
  return slice;
}

/// Which cells of the program are read other than by computing all anew: by slices, as values that do not
/// change with them, as choices and their parameters, by forms and by outputs.
std::vector<bool> cells_read(const ScoreProgram& program, const std::vector<Slice>& slices) {
  std::vector<bool> read(program.cells.size(), false);
  const auto operands_of = [&](const std::vector<Instruction>& code) {
    for (const Instruction& step : code)
      for (std::size_t k = 0; k < operation(step.op).arity; ++k)
        if (step.operands[k] < read.size()) read[step.operands[k]] = true;
  };
  for (const Slice& slice : slices) operands_of(slice.code);
  operands_of(program.form_code);
  operands_of(program.output_code);
  for (const auto* cells : {&program.outputs, &program.block.mixed})
    for (const Cell cell : *cells) read[cell] = true;
  for (const ScoreProgram::Choice& choice : program.choices) {
    if (choice.cell != kNoCell) read[choice.cell] = true;
    for (const auto* cells : {&choice.parameters, &choice.numbers, &choice.required})
      for (const Cell cell : *cells) read[cell] = true;
  }
  return read;
}

}  // namespace

std::vector<Slice> slices_of(const ScoreProgram& program) {
  Users users(program);
  Proposed proposed(program.cells.size());
  std::vector<Slice> slices;
  std::vector<Cell> floats;
  for (const ScoreProgram::Choice& choice : program.choices) {
    const bool open = choice.cell != kNoCell;
    slices.push_back(open ? slice_of(program, std::span(&choice.cell, 1), users, proposed) : Slice{});
    if (open && program.types[choice.cell] == Type::kFloat) floats.push_back(choice.cell);
  }
  slices.push_back(slice_of(program, floats, users, proposed));
  return slices;
}

void find_commits(const ScoreProgram& program, const std::vector<bool>& kept, std::vector<Slice>& slices) {
  const std::vector<bool> read = cells_read(program, slices);
  for (Slice& slice : slices) {
    std::copy_if(slice.changes.begin(), slice.changes.end(), std::back_inserter(slice.commits),
                 [&](const Slice::Changed& each) { return read[each.present] || kept[each.present]; });
    find_lasting({}, slice);
  }
}

void find_lasting(std::span<const Cell> more, Slice& slice) {
  if (slice.code.empty()) return;
  const Cell first = slice.code.front().result;  // the others follow one behind the other
  for (Instruction& step : slice.code) step.lasts = false;
  const auto lasts = [&](Cell cell) {
    if (cell != kNoCell && cell >= first) slice.code[cell - first].lasts = true;
  };
  for (const Slice::Changed& commit : slice.commits) lasts(commit.proposed);
  for (const auto* cells : {&slice.required, &slice.assumed})
    for (const Cell cell : *cells) lasts(cell);
  for (const Cell cell : more) lasts(cell);
  lasts(slice.difference);
}

}  // namespace solitaire
