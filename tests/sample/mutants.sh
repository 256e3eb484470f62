#!/bin/bash
# Sees to it that the tests of sampling notice what is wrong with it: changes one line after the other of a copy of
# the tree, builds the tests, and expects them to fail. For the nightly run; each mutant takes about a minute.
#
#     tests/sample/mutants.sh BUILD_FOLDER
#
# The folder is made if it is not there, and kept for the next time.
set -euo pipefail
source=$(cd "$(dirname "$0")/../.." && pwd)
build=$(mkdir -p "$1" && cd "$1" && pwd)
copy=$build/source
mkdir -p "$copy"

# FILE|what stands there|what is put in its place|what that is
mutants=(
  'engines/sample/rerun.cpp|std::log(count) - std::log(proposed_count)|0.0|the number of choices to pick from is forgotten'
  'engines/sample/rerun.cpp|+ forgotten() -|-|what is forgotten has no density'
  'engines/sample/rerun.cpp|drawn_density_ += domain.log_density(value);||what is drawn has no density'
  'engines/sample/proposal.cpp|return made(x * std::exp(step), step);|return made(x * std::exp(step), 0);|a walk on logarithms is taken for symmetric'
  'kernel/score_program.cpp|demands.terms.push_back(guarded(graph, choice.guard, density));|if (density == kFalse) demands.terms.push_back(density);|choices have no priors'
  'kernel/kernel.cpp|cells_[proposed].f - cells_[present].f|cells_[proposed].f|what a term was before is forgotten'
  'kernel/slice.cpp|step.operands[k] = proposed.read(step.operands[k]);|step.operands[k] = k == 0 ? proposed.read(step.operands[k]) : step.operands[k];|a second operand is stale'
  'engines/sample/conditional.cpp|draw_gamma(power + 1, rate, stream)|draw_gamma(power + 2, rate, stream)|a gamma form has one too many'
  'engines/sample/lightweight.cpp|if (warming_up_) steps_in_sweep_ = std::max(steps_in_sweep_, state_.choices.size());|steps_in_sweep_ = state_.choices.size();|a sweep is as long as the state is'
  'tracegraph/drawing.cpp|x = draw_normal(stream);|x = 1.1 * draw_normal(stream);|gamma numbers are too wide'
)

missed=0
for mutant in "${mutants[@]}"; do
  IFS='|' read -r file old new what <<<"$mutant"
  rsync -a --delete --exclude '/build*' --exclude '.git' "$source/" "$copy/"
  python3 - "$copy/$file" "$old" "$new" <<'PYTHON'
import sys
path, old, new = sys.argv[1:]
text = open(path).read()
assert text.count(old) == 1, f"{path} does not have this once: {old}"
open(path, "w").write(text.replace(old, new))
PYTHON
  [ -e "$build/build.ninja" ] || cmake -S "$copy" -B "$build" -G Ninja >/dev/null
  ninja -C "$build" solitaire_sample_tests >/dev/null
  if "$build/tests/sample/solitaire_sample_tests" >/dev/null 2>&1; then
    echo "not noticed: $what"
    missed=1
  else
    echo "noticed: $what"
  fi
done
exit $missed
