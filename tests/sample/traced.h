#pragma once
#include <doctest/doctest.h>

#include "engines/sample/rerun.h"
#include "engines/sample/shred/traced_structure.h"
#include "tests/sample/enumeration.h"

namespace solitaire {

/// A program with an execution that is drawn, and its trace.
struct Traced {
  explicit Traced(const char* text, std::uint64_t seed)
      : program(sampled_program(text)),
        stream(seed, Purpose::kSample, 1),
        rerun(program, params, {}, stream),
        state(rerun.start()),
        structure(trace_structure(program, params, state, rerun.addresses(), {}, ReturnedNumbers(program))) {
    REQUIRE(structure.load(state));
    rerun.stand_at(state);
  }
  Kernel& kernel() { return structure.kernel; }

  ParamValues params;
  Program program;
  RandomStream stream;
  Rerun rerun;
  SampledState state;
  TracedStructure structure;
};

}  // namespace solitaire
