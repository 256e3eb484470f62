#!/usr/bin/env python3
"""Sees to it that the tests of sampling notice what is wrong with it: builds the tests once from a copy of the tree in
which faults can be switched on, runs them with one fault after the other, and expects them to fail.

    tests/sample/mutants.py BUILD_FOLDER [CMAKE_OPTION...]

The folder is made if it is not there, and kept for the next time. Ends with status 1 if a mutant is not noticed.
"""
import os
import pathlib
import subprocess
import sys
from dataclasses import dataclass


@dataclass
class Mutant:
    what: str
    file: str
    old: str  # stands in the file once
    new: str  # the same with a fault where FAULTY is true
    tests: str  # the names of those that have to notice it, as doctest reads them


MUTANTS = [
    Mutant("the number of choices to pick from is forgotten",
           "engines/sample/rerun.cpp",
           "std::log(count) - std::log(proposed_count)",
           "(FAULTY ? 0.0 : std::log(count) - std::log(proposed_count))",
           "transitions*"),
    Mutant("what is forgotten has no density",
           "engines/sample/rerun.cpp",
           "if (!met_[i]) sum +=",
           "if (!met_[i] && !FAULTY) sum +=",
           "transitions*,each value*"),
    Mutant("what is drawn has no density",
           "engines/sample/rerun.cpp",
           "drawn_density_ += domain.log_density(value);",
           "if (!FAULTY) drawn_density_ += domain.log_density(value);",
           "transitions*,each value*"),
    Mutant("a walk on logarithms is taken for symmetric",
           "engines/sample/proposal.cpp",
           "coordinate.log_derivative(proposed) - coordinate.log_derivative(x)",
           "(FAULTY ? 0.0 : coordinate.log_derivative(proposed) - coordinate.log_derivative(x))",
           "chains over*,calibration*"),
    Mutant("a walk on log odds is taken for one on logarithms",
           "engines/sample/coordinate.cpp",
           "std::log((value - low_) * ((high_ - value) / (high_ - low_)))",
           "std::log(FAULTY ? value : (value - low_) * ((high_ - value) / (high_ - low_)))",
           "chains over*,calibration*,slice sampling*"),
    Mutant("choices have no priors",
           "kernel/score_program.cpp",
           "demands.terms.push_back(guarded(graph, choice.guard, density));",
           "if (!FAULTY) demands.terms.push_back(guarded(graph, choice.guard, density));",
           "kernel*"),
    Mutant("what a term was before is forgotten",
           "kernel/slice.cpp",
           "slice.terms[i].proposed, slice.terms[i].present)",
           "slice.terms[i].proposed, FAULTY ? slice.terms[i].proposed : slice.terms[i].present)",
           "kernel*"),
    Mutant("a second operand is stale",
           "kernel/slice.cpp",
           "step.operands[k] = proposed.read(step.operands[k]);",
           "if (!FAULTY || k == 0) step.operands[k] = proposed.read(step.operands[k]);",
           "kernel*"),
    Mutant("a condition that a change breaks is not looked at",
           "kernel/slice.cpp",
           "if (proposed[cell] != kNoCell) slice.required",
           "if (!FAULTY && proposed[cell] != kNoCell) slice.required",
           "kernel*"),
    Mutant("another path is not noticed",
           "kernel/slice.cpp",
           "if (proposed[cell] != kNoCell) slice.assumed",
           "if (!FAULTY && proposed[cell] != kNoCell) slice.assumed",
           "kernel*,each value*"),
    Mutant("an accepted change leaves the last cell as it was",
           "kernel/kernel.cpp",
           "void Kernel::accept() {",
           "void Kernel::accept() {\n  if (const auto& commits = slices_[proposed_].commits; FAULTY && commits.size() > 1) "
           "cells_[commits.back().proposed] = cells_[commits.back().present];",
           "kernel*"),
    Mutant("a gamma form has one too many",
           "engines/sample/shred/conditional.cpp",
           "draw_gamma(a + 1, -b, stream)",
           "draw_gamma(a + (FAULTY ? 2 : 1), -b, stream)",
           "forms*"),
    Mutant("a normal form is too wide",
           "engines/sample/shred/conditional.cpp",
           "draw_normal(stream) / std::sqrt(-2 * a)",
           "(FAULTY ? 1.2 : 1.0) * draw_normal(stream) / std::sqrt(-2 * a)",
           "forms*"),
    Mutant("a beta form has its shapes changed",
           "engines/sample/shred/conditional.cpp",
           "draw_beta(a + 1, b + 1, stream)",
           "(FAULTY ? draw_beta(b + 1, a + 1, stream) : draw_beta(a + 1, b + 1, stream))",
           "forms*"),
    Mutant("the numbers of a form forget what is alike",
           "kernel/combination.cpp",
           "sum.times += parts_[i++].times;",
           "sum.times += (FAULTY ? 0.0 : 1.0) * parts_[i++].times;",
           "forms*"),
    Mutant("the root of a square is what was squared",
           "kernel/forms.cpp",
           "if (!is_positive_) return {};",
           "if (!is_positive_ && !FAULTY) return {};",
           "forms*"),
    Mutant("values that conditions rule out have weights",
           "kernel/weights_of_values.cpp",
           "graph.phi(possible[i], weights[i].node(graph), never)",
           "graph.phi(FAULTY ? kTrue : possible[i], weights[i].node(graph), never)",
           "forms*,each value*"),
    Mutant("what values have in common is left out where they have it more or less often",
           "kernel/weights_of_values.cpp",
           "a.factors == b.factors && a.times == b.times",
           "a.factors == b.factors && (FAULTY || a.times == b.times)",
           "forms*"),
    Mutant("kept cells that only forms read are not made anew",
           "kernel/upkeep.cpp",
           "changed.insert(changed.end(), choice.required.begin(), choice.required.end());",
           "if (FAULTY) std::erase_if(changed, [&](Cell cell) { return !is_own(cell); });\n"
           "changed.insert(changed.end(), choice.required.begin(), choice.required.end());",
           "forms*"),
    Mutant("kept cells that only forms read stay as they are where a slice is accepted",
           "kernel/kernel.cpp",
           "if (!underived_) run_code(upkeep_.accepted",
           "if (!underived_ && !FAULTY) run_code(upkeep_.accepted",
           "forms*"),
    Mutant("a cell is kept only where forms read it",
           "kernel/upkeep.cpp",
           "if (operand < kept_.size()) kept_[operand] = true;",
           "if (operand < kept_.size() && !FAULTY) kept_[operand] = true;",
           "forms*"),
    Mutant("a slice reads what changes have left behind",
           "kernel/kernel.cpp",
           "if (stale_ && program_.choices[choice].form != Form::kUnknown) refresh();",
           "if (stale_ && program_.choices[choice].form != Form::kUnknown && !FAULTY) refresh();",
           "forms*"),
    Mutant("a change of known form may break a condition",
           "kernel/kernel.cpp",
           "return made && std::all_of(at.required",
           "return made && FAULTY ? true : made && std::all_of(at.required",
           "forms*,each value*"),
    Mutant("an execution drawn anew is compared with a density of another state",
           "engines/sample/shred/shred.cpp",
           "present.refresh();",
           "if (!FAULTY) present.refresh();",
           "each value*,values of*,transitions*"),
    Mutant("normal numbers have no tails",
           "tracegraph/drawing.cpp",
           "if (2 * y > x * x) return kEnd + x;",
           "if (FAULTY || 2 * y > x * x) return FAULTY ? kEnd : kEnd + x;",
           "drawing*"),
    Mutant("normal numbers come from layers alone",
           "tracegraph/drawing.cpp",
           "if (low + stream.uniform() * (high - low) < density(x)) return x;",
           "if (FAULTY || low + stream.uniform() * (high - low) < density(x)) return x;",
           "drawing*"),
    Mutant("a sweep is as long as the state is",
           "engines/sample/lightweight.cpp",
           "if (warming_up_) steps_in_sweep_ = std::max(steps_in_sweep_, state_.choices.size());",
           "if (FAULTY) steps_in_sweep_ = state_.choices.size();\n"
           "  if (warming_up_) steps_in_sweep_ = std::max(steps_in_sweep_, state_.choices.size());",
           "each value*,transitions*"),
    Mutant("gamma numbers are too wide",
           "tracegraph/drawing.cpp",
           "x = draw_normal(stream);",
           "x = (FAULTY ? 1.1 : 1.0) * draw_normal(stream);",
           "chains over*,forms*"),
    Mutant("the form of a choice is that between the ends of one execution",
           "kernel/forms.cpp",
           "(distribution.family == Family::kUniform && fixed_parameters &&",
           "(distribution.family == Family::kUniform && (FAULTY || fixed_parameters) &&",
           "forms*"),
    Mutant("on known paths a value may be one that the choice cannot have there",
           "engines/sample/shred/path_run.cpp",
           "return possible ? outcome",
           "return possible || FAULTY ? outcome",
           "each value*,values of*"),
    Mutant("the side that is not taken weighs, too",
           "solitaire/run/statements.cpp",
           "select(condition, none, weight, span)",
           "FAULTY ? weight : select(condition, none, weight, span)",
           "each value*,kernel*"),
    Mutant("the ends of a range are those of one execution",
           "solitaire/run/evaluation.cpp",
           "graph_->choice({address, of_path(domain, lo, hi, step)})",
           "graph_->choice({address, FAULTY ? domain : of_path(domain, lo, hi, step)})",
           "each value*"),
    Mutant("compiled code believes registers after a call",
           "kernel/registers.h",
           "void forget() { held_.fill({}); }",
           "void forget() {\n    if (!FAULTY) held_.fill({});\n  }",
           "compiler*"),
    Mutant("a float that gives way to another one is lost",
           "kernel/code_writer.h",
           "if (oldest.cell != kNoCell) write_back(oldest);",
           "if (oldest.cell != kNoCell && !FAULTY) write_back(oldest);",
           "compiler*"),
    Mutant("a float that a call may overwrite is lost",
           "kernel/code_writer.h",
           "if (held.cell != kNoCell && is_read_again(held.cell)) write_back(held);",
           "if (held.cell != kNoCell && is_read_again(held.cell) && !FAULTY) write_back(held);",
           "compiler*"),
    Mutant("a kept cell is not written by machine code",
           "kernel/upkeep.cpp",
           "lasts = kept_[made.back().result] ||",
           "lasts = (!FAULTY && kept_[made.back().result]) ||",
           "forms*"),
    Mutant("two floats that are drawn together do not hang together",
           "kernel/kernel.cpp",
           "numbers_.push_back(-cells_[*mixed++].f);",
           "numbers_.push_back((FAULTY ? 0.0 : -1.0) * cells_[*mixed++].f);",
           "block*"),
    Mutant("floats are drawn together where they multiply each other",
           "kernel/normal_block.cpp",
           "(!slopes_[i][j] || !is_fixed(*slopes_[i][j]))",
           "(!slopes_[i][j] || (!FAULTY && !is_fixed(*slopes_[i][j])))",
           "block*"),
    Mutant("floats that are drawn together are too near their mean",
           "engines/sample/shred/block_draw.cpp",
           "each += draw_normal(stream);",
           "each += (FAULTY ? 0.8 : 1.0) * draw_normal(stream);",
           "block*"),
    Mutant("a path that draws its floats together forgets the density of those it leaves",
           "engines/sample/shred/path_run.cpp",
           "(from.kernel.log_score() - from.block.log_density());",
           "(from.kernel.log_score() - (FAULTY ? 0.0 : from.block.log_density()));",
           "models: exact*"),
    Mutant("the score keeps the rounding of a start where it was large",
           "kernel/kernel.cpp",
           "largest_score_ > kMostShrunk * (1 + size)",
           "(!FAULTY && largest_score_ > kMostShrunk * (1 + size))",
           "models: a start*"),
    Mutant("where a trajectory comes to an infinite density it is forgotten",
           "kernel/kernel.cpp",
           "(*infinite_)[floats_[i]] = cells_[program_.cells.size() + i];",
           "if (!FAULTY) (*infinite_)[floats_[i]] = cells_[program_.cells.size() + i];",
           "models: where a trajectory*"),
    Mutant("terms that depend on the same choices are left out but for the first",
           "kernel/score_program.cpp",
           "for (const NodeId term : alike) sum.add(Combination(graph, term));",
           "for (const NodeId term : alike)\n      if (!FAULTY || term == alike[0]) sum.add(Combination(graph, term));",
           "kernel*"),
    Mutant("slice sampling looks for values in a coordinate, and at densities of the values",
           "engines/sample/shred/slice_sampler.cpp",
           "if (!is_float()) return kernel_.difference();",
           "if (FAULTY || !is_float()) return kernel_.difference();",
           "slice sampling*"),
    Mutant("the level of slice sampling is not drawn",
           "engines/sample/shred/slice_sampler.cpp",
           "const double level = std::log(stream_.uniform());",
           "const double level = FAULTY ? -0.7 : std::log(stream_.uniform());",
           "slice sampling*"),
    Mutant("slice sampling begins with an interval at the start",
           "engines/sample/shred/slice_sampler.cpp",
           "line.start() - width * stream_.uniform()",
           "line.start() - (FAULTY ? 0.0 : width * stream_.uniform())",
           "slice sampling*"),
    Mutant("floats move together as if their coordinates were plain",
           "engines/sample/shred/float_space.cpp",
           "height += coordinates_[i].log_derivative(values_[i]);",
           "height += FAULTY ? 0.0 : coordinates_[i].log_derivative(values_[i]);",
           "joint moves*,chains over*,calibration*"),
    Mutant("a float between ends that move has a coordinate between the ends of one execution",
           "engines/sample/shred/float_space.cpp",
           "has_ends && !choice.fixed_parameters",
           "has_ends && !choice.fixed_parameters && !FAULTY",
           "joint moves*"),
    Mutant("what was drawn before a path was found to be another one is drawn anew",
           "engines/sample/fresh_values.h",
           "if (drawn.proposal != proposal_",
           "if (FAULTY || drawn.proposal != proposal_",
           "each value*,transitions*"),
    Mutant("on known paths the number of choices to pick from is forgotten",
           "engines/sample/shred/path_run.cpp",
           "std::log(count) - std::log(proposed_count)",
           "(FAULTY ? 0.0 : std::log(count) - std::log(proposed_count))",
           "transitions*"),
    Mutant("on known paths what is forgotten has no density",
           "engines/sample/shred/path_run.cpp",
           "for (const ChoiceNumber each : passage.forgotten) forgotten +=",
           "for (const ChoiceNumber each : passage.forgotten) forgotten += FAULTY ? 0.0 :",
           "transitions*,each value*"),
    Mutant("on known paths what is drawn has no density",
           "engines/sample/shred/path_run.cpp",
           "drawn_density_ += distribution.log_density(drawn);",
           "if (!FAULTY) drawn_density_ += distribution.log_density(drawn);",
           "transitions*,each value*"),
    Mutant("a path is followed past where it turns off",
           "kernel/kernel.cpp",
           "std::all_of(assumed.begin(), assumed.end(), [&](Cell cell) { return holds(cell); });",
           "std::all_of(assumed.begin(), assumed.end(), [&](Cell cell) { return FAULTY || holds(cell); });",
           "each value*,transitions*,kernel*"),
    Mutant("points of a trajectory are drawn without regard to their weights",
           "engines/sample/shred/trajectory.cpp",
           "if (stream_.uniform() < probability)",
           "if (stream_.uniform() < (FAULTY ? 0.5 : probability))",
           "joint moves*,chains over*"),
    Mutant("a trajectory that goes on from its far end counts as the way back",
           "engines/sample/shred/trajectory.cpp",
           "build(forward ? part.high : part.low, time, depth - 1, second)",
           "build(forward != FAULTY ? part.high : part.low, time, depth - 1, second)",
           "joint moves*,chains over*"),
    Mutant("what is subtracted has the slope of what is added",
           "kernel/gradient.cpp",
           "if (depends(b)) count(b, {negated(d), result_.guarded});",
           "if (depends(b)) count(b, {FAULTY ? d : negated(d), result_.guarded});",
           "gradient*"),
    Mutant("what is not selected has a slope",
           "kernel/gradient.cpp",
           "{emit(Op::kIteFloat, condition, zero_, result_.cell), true}",
           "{FAULTY ? result_.cell : emit(Op::kIteFloat, condition, zero_, result_.cell), true}",
           "gradient*"),
]

SWITCH = """#ifndef SOLITAIRE_FAULTY
#define SOLITAIRE_FAULTY
#include <cstdlib>
inline bool faulty(int number) {
  static const char* const chosen = std::getenv("SOLITAIRE_MUTANT");
  return chosen != nullptr && std::atoi(chosen) == number;
}
#endif
"""


def with_faults(name, text):
    """The text of a file in which the environment switches its faults on, each by its number."""
    changed = text
    for number, mutant in enumerate(MUTANTS, 1):
        if mutant.file == name:
            assert changed.count(mutant.old) == 1, f"{name} does not have this once: {mutant.old}"
            changed = changed.replace(mutant.old, mutant.new.replace("FAULTY", f"faulty({number})"))
    return text if changed == text else SWITCH + changed


def copy_tree(source, folder):
    """Writes those of the tree's files alone that differ, so that little is built anew, and removes those that it has no more."""
    listed = subprocess.run(["git", "-C", source, "ls-files", "-z"], check=True, capture_output=True).stdout
    names = {name for name in listed.decode().split("\0") if name and (source / name).is_file()}
    for path in folder.rglob("*"):
        if path.is_file() and str(path.relative_to(folder)) not in names:
            path.unlink()
    for name in names:
        content = (source / name).read_bytes()
        if any(mutant.file == name for mutant in MUTANTS):
            content = with_faults(name, content.decode()).encode()
        path = folder / name
        if not path.exists() or path.read_bytes() != content:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
            path.chmod((source / name).stat().st_mode)


def tests_pass(build, names="*", number=0):
    program = build / "tests/sample/solitaire_sample_tests"
    command = [program, "--abort-after=1", f"--test-case={names}"]
    environment = {**os.environ, "SOLITAIRE_MUTANT": str(number)}
    tests = subprocess.run(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=1800)
    return tests.returncode == 0


def main():
    source = pathlib.Path(__file__).resolve().parents[2]
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    copy_tree(source, build / "source")
    if not (build / "build.ninja").exists():
        configure = ["cmake", "-S", build / "source", "-B", build, "-G", "Ninja", "-DSOLITAIRE_TESTS=ON", *sys.argv[2:]]
        subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["ninja", "-C", build, "solitaire_sample_tests"], check=True, stdout=subprocess.DEVNULL)
    missed = 0
    for number, mutant in enumerate(MUTANTS, 1):
        noticed = not tests_pass(build, mutant.tests, number)
        print("noticed:" if noticed else "NOT NOTICED:", mutant.what, flush=True)
        missed += not noticed
    if not tests_pass(build):
        sys.exit("the tests fail without a mutant")
    sys.exit(missed > 0)


if __name__ == "__main__":
    main()
