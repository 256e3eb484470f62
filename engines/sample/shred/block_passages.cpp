#include "engines/sample/shred/block_passages.h"

#include <algorithm>

namespace solitaire {
namespace {

bool in_block(const Kernel& kernel, ChoiceNumber choice) {
  const std::vector<ChoiceNumber>& block = kernel.program().block.choices;
  return std::binary_search(block.begin(), block.end(), choice);
}

/// Returns true if nothing but floats of the blocks comes and goes, and what stays is in both blocks or in
/// none.
bool only_blocks_differ(const Passage& passage, const Kernel& here, const Kernel& there) {
  for (ChoiceNumber i = 0; i < passage.origins.size(); ++i) {
    const ChoiceNumber origin = passage.origins[i];
    const bool was_in_block = origin == Passage::kNew || in_block(here, origin);
    if (in_block(there, i) != was_in_block) return false;
  }
  return std::all_of(passage.forgotten.begin(), passage.forgotten.end(),
                     [&](ChoiceNumber each) { return in_block(here, each); });
}

}  // namespace

void let_draw_block(TracedStructure& a, TracedStructure& b) {
  Passage* const there = a.passages.between(a.kernel, &b, b.kernel);
  Passage* const back = b.passages.between(b.kernel, &a, a.kernel);
  if (there == nullptr || back == nullptr || !only_blocks_differ(*there, a.kernel, b.kernel)) return;
  a.passages.let_draw_block(there);
  b.passages.let_draw_block(back);
}

}  // namespace solitaire
