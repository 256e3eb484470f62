#include "kernel/slice.h"

#include <algorithm>

namespace solitaire {
namespace {

/// Finds what depends on a cell: the numbers of the instructions that read each cell.
class Users {
 public:
  explicit Users(const ScoreProgram& program)
      : users_(program.cells.size()), seen_(program.code.size(), false) {
    for (std::uint32_t i = 0; i < program.code.size(); ++i) {
      const Instruction& step = program.code[i];
      for (std::size_t k = 0; k < operation(step.op).arity; ++k) {
        auto& users = users_[step.operands[k]];
        if (users.empty() || users.back() != i) users.push_back(i);
      }
    }
  }

  /// The instructions whose results depend on the cell, in the order of the program.
  std::vector<std::uint32_t> closure(const ScoreProgram& program, Cell cell) {
    std::vector<std::uint32_t> found;
    std::vector<Cell> open{cell};
    while (!open.empty()) {
      const Cell at = open.back();
      open.pop_back();
      for (const std::uint32_t user : users_[at]) {
        if (seen_[user]) continue;
        seen_[user] = true;
        found.push_back(user);
        open.push_back(program.code[user].result);
      }
    }
    for (const std::uint32_t user : found) seen_[user] = false;
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  std::vector<std::vector<std::uint32_t>> users_;
  std::vector<bool> seen_;
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

Slice slice_of(const ScoreProgram& program, Cell choice, Users& users, Proposed& proposed) {
  Slice slice;
  const auto change = [&](Cell present) {
    const auto at = static_cast<Cell>(program.cells.size() + slice.changes.size());
    slice.changes.push_back({present, at});
    proposed.set(present, at);
    return at;
  };
  change(choice);
  for (const std::uint32_t number : users.closure(program, choice)) {
    Instruction step = program.code[number];
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
  return slice;
}

}  // namespace

std::vector<Slice> slices_of(const ScoreProgram& program) {
  Users users(program);
  Proposed proposed(program.cells.size());
  std::vector<Slice> slices;
  for (const ScoreProgram::Choice& choice : program.choices)
    slices.push_back(choice.cell == kNoCell ? Slice{} : slice_of(program, choice.cell, users, proposed));
  return slices;
}

}  // namespace solitaire
