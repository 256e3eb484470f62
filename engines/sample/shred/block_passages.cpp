#include "engines/sample/shred/block_passages.h"

#include <algorithm>

namespace solitaire {
namespace {

/// Returns true if nothing but floats of the blocks comes and goes, and what stays is in both blocks or in
/// none.
bool only_blocks_differ(const Passage& passage, const ScoreProgram::Block& here,
                        const ScoreProgram::Block& there) {
  for (ChoiceNumber i = 0; i < passage.origins.size(); ++i) {
    const ChoiceNumber origin = passage.origins[i];
    const bool was_in_block = origin == Passage::kNew || here.has(origin);
    if (there.has(i) != was_in_block) return false;
  }
  return std::all_of(passage.forgotten.begin(), passage.forgotten.end(),
                     [&](ChoiceNumber each) { return here.has(each); });
}

}  // namespace

void let_draw_block(TracedStructure& a, TracedStructure& b) {
  Passage* const there = a.passages.between(a.kernel, &b, b.kernel);
  Passage* const back = b.passages.between(b.kernel, &a, a.kernel);
  if (there == nullptr || back == nullptr) return;
  if (!only_blocks_differ(*there, a.kernel.program().block, b.kernel.program().block)) return;
  a.passages.let_draw_block(there);
  b.passages.let_draw_block(back);
}

}  // namespace solitaire
