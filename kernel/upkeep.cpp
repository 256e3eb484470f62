#include "kernel/upkeep.h"

#include <algorithm>
#include <iterator>
#include <span>

#include "kernel/dependents.h"
#include "kernel/few.h"

namespace solitaire {
namespace {

constexpr std::uint32_t kNoInstruction = UINT32_MAX;

/// All code of a program as one, in an order in which it can run, and who makes and uses its cells.
class WholeCode {
 public:
  explicit WholeCode(const ScoreProgram& program)
      : maker_(program.cells.size(), kNoInstruction), dependents_(program.cells.size()) {
    for (const auto* code : {&program.code, &program.form_code, &program.output_code})
      code_.insert(code_.end(), code->begin(), code->end());
    for (std::uint32_t i = 0; i < code_.size(); ++i) {
      maker_[code_[i].result] = i;
      for (const Cell operand : operands(code_[i])) dependents_.add(operand, code_[i].result);
    }
  }

  static std::span<const Cell> operands(const Instruction& step) {
    return {step.operands.data(), operation(step.op).arity};
  }
  const std::vector<Instruction>& code() const { return code_; }
  bool is_made(Cell cell) const { return maker_[cell] != kNoInstruction; }
  std::uint32_t maker(Cell cell) const { return maker_[cell]; }
  std::vector<Cell> dependents(Cell cell) { return dependents_.closure(std::span(&cell, 1)); }

 private:
  std::vector<Instruction> code_;
  std::vector<std::uint32_t> maker_;
  Dependents dependents_;
};

/// Decides which cells are kept.
class Keeping {
 public:
  Keeping(const ScoreProgram& program, const WholeCode& whole, const std::vector<Slice>& slices)
      : program_(program), whole_(whole), kept_(program.cells.size(), false), readers_(program.cells.size()) {
    keep_what_others_read(slices);
    find_changes();
    for (std::uint32_t i = 0; i < program.choices.size(); ++i)
      for (const Cell cell : program.choices[i].numbers) readers_[cell].add(drawn_with(i));
    for (const Cell cell : program.block.mixed) readers_[cell].add(drawn_with(program.block.choices[0]));
    for (const Cell cell : program.outputs)
      readers_[cell].add(static_cast<std::uint32_t>(program.choices.size()));
    for (std::size_t i = whole.code().size(); i-- > 0;) decide(whole.code()[i]);
  }

  const std::vector<bool>& kept() const { return kept_; }

 private:
  void keep_what_others_read(const std::vector<Slice>& slices) {
    for (std::size_t i = 0; i < program_.choices.size(); ++i) {
      for (const Cell parameter : program_.choices[i].parameters) kept_[parameter] = true;
      if (program_.choices[i].form != Form::kUnknown) continue;
      for (const Instruction& step : slices[i].code)
        for (const Cell operand : WholeCode::operands(step))
          if (operand < kept_.size()) kept_[operand] = true;
    }
  }

  /// Which choices change each cell.
  void find_changes() {
    changes_.resize(program_.cells.size());
    for (std::uint32_t i = 0; i < program_.choices.size(); ++i)
      if (program_.choices[i].cell != kNoCell) changes_[program_.choices[i].cell].add(drawn_with(i));
    for (const Instruction& step : whole_.code())
      for (const Cell operand : WholeCode::operands(step)) changes_[step.result].add(changes_[operand]);
  }

  /// The floats of the block are drawn, and change, as one.
  std::uint32_t drawn_with(std::size_t choice) const {
    return static_cast<std::uint32_t>(program_.block.has(choice) ? program_.block.choices[0] : choice);
  }

  /// Users come before what they use. A kept cell is made by the code that follows a change, and any other
  /// one by whatever code needs it.
  void decide(const Instruction& step) {
    const Few& readers = readers_[step.result];
    const Few& changes = changes_[step.result];
    if (!kept_[step.result]) kept_[step.result] = is_worth_keeping(readers, changes);
    for (const Cell operand : WholeCode::operands(step)) {
      if (!kept_[step.result]) {
        readers_[operand].add(readers);
      } else if (changes.many()) {
        readers_[operand].add_many();
      } else {
        for (const std::uint32_t choice : changes)
          readers_[operand].add(static_cast<std::uint32_t>(program_.choices.size()) + 1 + choice);
      }
    }
  }
  static bool is_worth_keeping(const Few& readers, const Few& changes) {
    if (readers.many()) return true;
    return !changes.many() && readers.size() > changes.size();
  }

  const ScoreProgram& program_;
  const WholeCode& whole_;
  std::vector<bool> kept_;
  std::vector<Few> readers_, changes_;
};

/// Picks the code that makes cells out of the whole code.
class Picking {
 public:
  Picking(const WholeCode& whole, const std::vector<bool>& kept)
      : whole_(whole), kept_(kept), asked_(kept.size(), false), seen_(whole.code().size(), false) {}

  /// Makes kept cells, if `anew` has them, and others from kept ones. Those that are asked for last, and of
  /// these alone are any kept.
  std::vector<Instruction> code(const std::vector<Cell>& cells, bool anew) {
    std::vector<std::uint32_t> found;
    std::vector<Cell> open;
    const auto need = [&](Cell cell) {
      if (!whole_.is_made(cell) || seen_[whole_.maker(cell)]) return;
      seen_[whole_.maker(cell)] = true;
      found.push_back(whole_.maker(cell));
      open.push_back(cell);
    };
    for (const Cell cell : cells) {
      asked_[cell] = true;
      if (anew || !kept_[cell]) need(cell);
    }
    while (!open.empty()) {
      const Instruction& step = whole_.code()[whole_.maker(open.back())];
      open.pop_back();
      for (const Cell operand : WholeCode::operands(step))
        if (!kept_[operand]) need(operand);
    }
    std::sort(found.begin(), found.end());
    std::vector<Instruction> made;
    for (const std::uint32_t number : found) {
      seen_[number] = false;
      made.push_back(whole_.code()[number]);
      made.back().lasts = asked_[made.back().result];
    }
    for (const Cell cell : cells) asked_[cell] = false;
    return made;
  }

 private:
  const WholeCode& whole_;
  const std::vector<bool>& kept_;
  std::vector<bool> asked_;  // of the cells
  std::vector<bool> seen_;   // of the instructions
};

/// What is kept and depends on a choice.
std::vector<Cell> kept_dependents(const ScoreProgram::Choice& choice, const std::vector<bool>& kept,
                                  WholeCode& whole) {
  std::vector<Cell> found;
  if (choice.cell != kNoCell) found = whole.dependents(choice.cell);
  std::erase_if(found, [&](Cell cell) { return !kept[cell]; });
  return found;
}

/// All that follows the floats of the block, and all that they follow from.
void add_block(const ScoreProgram& program, const std::vector<bool>& kept, WholeCode& whole, Picking& picking,
               Upkeep& upkeep) {
  std::vector<Cell> changed, numbers = program.block.mixed;
  for (const std::size_t number : program.block.choices) {
    const ScoreProgram::Choice& choice = program.choices[number];
    numbers.insert(numbers.end(), choice.numbers.begin(), choice.numbers.end());
    const std::vector<Cell> dependents = kept_dependents(choice, kept, whole);
    changed.insert(changed.end(), dependents.begin(), dependents.end());
  }
  upkeep.block_form = picking.code(numbers, false);
  upkeep.block_change = picking.code(changed, true);
}

}  // namespace

Upkeep upkeep_of(const ScoreProgram& program, const std::vector<Slice>& slices) {
  WholeCode whole(program);
  const Keeping keeping(program, whole, slices);
  const std::vector<bool>& kept = keeping.kept();
  Picking picking(whole, kept);
  const auto is_own = [&](Cell cell) { return whole.maker(cell) < program.code.size(); };
  Upkeep made;
  made.kept = kept;
  for (const ScoreProgram::Choice& choice : program.choices) {
    made.forms.push_back(picking.code(choice.numbers, false));
    std::vector<Cell> changed = kept_dependents(choice, kept, whole), derived;
    std::copy_if(changed.begin(), changed.end(), std::back_inserter(derived),
                 [&](Cell cell) { return !is_own(cell); });
    changed.insert(changed.end(), choice.required.begin(), choice.required.end());
    made.changes.push_back(picking.code(changed, true));
    made.accepted.push_back(picking.code(derived, true));
  }
  add_block(program, kept, whole, picking, made);
  std::vector<Cell> derived;
  for (const auto* code : {&program.form_code, &program.output_code})
    for (const Instruction& step : *code)
      if (kept[step.result]) derived.push_back(step.result);
  made.derived = picking.code(derived, true);
  made.outputs = picking.code(program.outputs, false);
  return made;
}

}  // namespace solitaire
