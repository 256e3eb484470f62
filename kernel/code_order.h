#pragma once
#include <span>
#include <vector>

#include "kernel/places.h"
#include "kernel/score_program.h"

namespace solitaire {

/// Puts instructions into an order in which each result is made shortly before it is read, so that few are
/// needed at a time: what a lasting result is made of comes before it, and nothing else. Leaves out what
/// nothing needs.
class CodeOrder {
 public:
  std::vector<Instruction> of(std::span<const Instruction> code) {
    makers_.clear();
    for (std::size_t i = 0; i < code.size(); ++i) makers_.set(code[i].result, i);
    made_.assign(code.size(), false);
    std::vector<Instruction> ordered;
    for (std::size_t i = 0; i < code.size(); ++i)
      if (code[i].lasts || code[i].op == Op::kFloor) add(code, i, ordered);
    return ordered;
  }

 private:
  struct Open {
    std::size_t place;
    std::size_t operand;  // that is looked at next
  };

  void add(std::span<const Instruction> code, std::size_t place, std::vector<Instruction>& ordered) {
    open_.assign(1, {place, 0});
    while (!open_.empty()) {
      auto& [at, operand] = open_.back();
      const Instruction& step = code[at];
      if (!made_[at] && operand < operation(step.op).arity) {
        const std::size_t* const maker = makers_.find(step.operands[operand++]);
        if (maker != nullptr && !made_[*maker]) open_.push_back({*maker, 0});
        continue;
      }
      if (!made_[at]) ordered.push_back(step);
      made_[at] = true;
      open_.pop_back();
    }
  }

  Places makers_;  // of the results
  std::vector<bool> made_;
  std::vector<Open> open_;
};

}  // namespace solitaire
