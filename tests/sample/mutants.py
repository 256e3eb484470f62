#!/usr/bin/env python3
"""Sees to it that the tests of sampling notice what is wrong with it: changes one line after the other of a copy of the
tree, builds the tests, and expects them to fail. For the nightly run; each mutant takes about a minute.

    tests/sample/mutants.py BUILD_FOLDER [CMAKE_OPTION...]

The folder is made if it is not there, and kept for the next time. Ends with status 1 if a mutant is not noticed.
"""
import pathlib
import subprocess
import sys
from dataclasses import dataclass


@dataclass
class Mutant:
    what: str
    file: str
    old: str  # stands in the file once
    new: str
    tests: str  # the names of those that have to notice it, as doctest reads them


MUTANTS = [
    Mutant("the number of choices to pick from is forgotten", "engines/sample/rerun.cpp",
           "std::log(count) - std::log(proposed_count)", "0.0 * (count - proposed_count)", "transitions*"),
    Mutant("what is forgotten has no density", "engines/sample/rerun.cpp",
           "if (!met_[i]) sum += state_->log_priors[i];", "if (!met_[i]) sum += 0 * state_->log_priors[i];",
           "transitions*,each value*"),
    Mutant("what is drawn has no density", "engines/sample/rerun.cpp",
           "drawn_density_ += domain.log_density(value);", "drawn_density_ += 0 * domain.log_density(value);",
           "transitions*,each value*"),
    Mutant("a walk on logarithms is taken for symmetric", "engines/sample/proposal.cpp",
           "log_derivative(coordinate, proposed) - log_derivative(coordinate, x);",
           "0.0 * log_derivative(coordinate, proposed);", "chains over*,calibration*"),
    Mutant("a walk on log odds is taken for one on logarithms", "engines/sample/coordinate.cpp",
           "std::log(value) : std::log(value * (1 - value))", "std::log(value) : std::log(value)",
           "chains over*,calibration*"),
    Mutant("floats walk together as if their coordinates were plain", "engines/sample/shred.cpp",
           "log_ratio += log_derivative(coordinate, to[i])", "log_ratio += 0.0 * log_derivative(coordinate, to[i])",
           "chains over*"),
    Mutant("choices have no priors", "kernel/score_program.cpp",
           "demands.terms.push_back(guarded(graph, choice.guard, density));",
           "if (density == kFalse) demands.terms.push_back(density);", "kernel*"),
    Mutant("what a term was before is forgotten", "kernel/slice.cpp",
           "slice.terms[i].proposed, slice.terms[i].present)", "slice.terms[i].proposed, slice.terms[i].proposed)",
           "kernel*"),
    Mutant("a second operand is stale", "kernel/slice.cpp",
           "step.operands[k] = proposed.read(step.operands[k]);",
           "step.operands[k] = k == 0 ? proposed.read(step.operands[k]) : step.operands[k];", "kernel*"),
    Mutant("a condition that a change breaks is not looked at", "kernel/slice.cpp",
           "if (proposed[cell] != kNoCell) slice.required.push_back(proposed[cell]);",
           "if (proposed[cell] == kNoCell - 1) slice.required.push_back(proposed[cell]);", "kernel*"),
    Mutant("another path is not noticed", "kernel/slice.cpp",
           "if (proposed[cell] != kNoCell) slice.assumed.push_back(proposed[cell]);",
           "if (proposed[cell] == kNoCell - 1) slice.assumed.push_back(proposed[cell]);", "kernel*,each value*"),
    Mutant("an accepted change leaves the last cell as it was", "kernel/kernel.cpp",
           "void Kernel::accept() {", "void Kernel::accept() {\n  if (slices_[proposed_].commits.size() > 1) "
           "cells_[slices_[proposed_].commits.back().proposed] = cells_[slices_[proposed_].commits.back().present];",
           "kernel*"),
    Mutant("a gamma form has one too many", "engines/sample/conditional.cpp",
           "draw_gamma(power + 1, rate, stream)", "draw_gamma(power + 2, rate, stream)", "forms*"),
    Mutant("a normal form is too wide", "engines/sample/conditional.cpp",
           "draw_normal(stream) / std::sqrt(-curvature)", "1.2 * draw_normal(stream) / std::sqrt(-curvature)", "forms*"),
    Mutant("a beta form has its shapes changed", "engines/sample/conditional.cpp",
           "draw_beta(a + 1, b + 1, stream)", "draw_beta(b + 1, a + 1, stream)", "forms*"),
    Mutant("a sweep is as long as the state is", "engines/sample/lightweight.cpp",
           "if (warming_up_) steps_in_sweep_ = std::max(steps_in_sweep_, state_.choices.size());",
           "steps_in_sweep_ = state_.choices.size();", "each value*,transitions*"),
    Mutant("gamma numbers are too wide", "tracegraph/drawing.cpp",
           "x = draw_normal(stream);", "x = 1.1 * draw_normal(stream);", "chains over*,forms*"),
    Mutant("the ends of a range are those of one execution", "solitaire/run/evaluation.cpp",
           "graph_->choice({address, of_path(domain, lo, hi, step)})", "graph_->choice({address, domain})", "each value*"),
    Mutant("compiled code believes registers after a call", "kernel/compiler.cpp",
           "void forget() { held_.fill({}); }", "void forget() {}", "compiler*"),
]


class Copy:
    """A copy of the tree's files, of which those alone are written that differ, so that little is built anew."""

    def __init__(self, source, folder):
        self.source, self.folder = source, folder
        listed = subprocess.run(["git", "-C", source, "ls-files", "-z"], check=True, capture_output=True).stdout
        for name in filter(None, listed.decode().split("\0")):
            if (source / name).is_file():
                self.write(name, (source / name).read_bytes())

    def write(self, name, content):
        path = self.folder / name
        if not path.exists() or path.read_bytes() != content:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
            path.chmod((self.source / name).stat().st_mode)

    def change(self, mutant):
        text = (self.source / mutant.file).read_text()
        assert text.count(mutant.old) == 1, f"{mutant.file} does not have this once: {mutant.old}"
        self.write(mutant.file, text.replace(mutant.old, mutant.new).encode())

    def restore(self, mutant):
        self.write(mutant.file, (self.source / mutant.file).read_bytes())


def tests_pass(build, names="*"):
    subprocess.run(["ninja", "-C", build, "solitaire_sample_tests"], check=True, stdout=subprocess.DEVNULL)
    program = build / "tests/sample/solitaire_sample_tests"
    command = [program, "--abort-after=1", f"--test-case={names}"]
    tests = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=1800)
    return tests.returncode == 0


def main():
    source = pathlib.Path(__file__).resolve().parents[2]
    build = pathlib.Path(sys.argv[1]).resolve()
    copy = Copy(source, build / "source")
    if not (build / "build.ninja").exists():
        configure = ["cmake", "-S", copy.folder, "-B", build, "-G", "Ninja", "-DSOLITAIRE_TESTS=ON", *sys.argv[2:]]
        subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)
    if not tests_pass(build):
        sys.exit("the tests fail without a mutant")
    missed = 0
    for mutant in MUTANTS:
        copy.change(mutant)
        noticed = not tests_pass(build, mutant.tests)
        print("noticed:" if noticed else "NOT NOTICED:", mutant.what, flush=True)
        missed += not noticed
        copy.restore(mutant)
    sys.exit(missed > 0)


if __name__ == "__main__":
    main()
