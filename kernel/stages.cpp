#include "kernel/stages.h"

#include <algorithm>

namespace solitaire {
namespace {

/// For each choice, the first cell of it and of those after it: cells below were made before it was met, for
/// nodes are numbered as an execution makes them.
std::vector<Cell> first_unknown(const ScoreProgram& program) {
  std::vector<Cell> first(program.choices.size() + 1, kNoCell);
  for (std::size_t i = program.choices.size(); i-- > 0;)
    first[i] = std::min(program.choices[i].cell, first[i + 1]);
  return first;
}

}  // namespace

std::vector<Stage> stages_of(const ScoreProgram& program) {
  std::vector<Cell> assumed = program.assumed;
  std::sort(assumed.begin(), assumed.end());
  std::vector<Stage> stages;
  auto condition = assumed.cbegin();
  std::size_t code = 0;
  for (const Cell end : first_unknown(program)) {
    while (code < program.code.size() && program.code[code].result < end) ++code;
    const auto last = std::lower_bound(condition, assumed.cend(), end);
    stages.push_back({code, {condition, last}});
    condition = last;
  }
  return stages;
}

}  // namespace solitaire
