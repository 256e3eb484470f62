#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "engines/exhaustive/exhaustive.h"
#include "engines/solve/tracing.h"
#include "solitaire/names/analyze.h"

namespace solitaire {

/// Where a test's scripts are.
std::filesystem::path tests_folder();

/// The folders that scripts import the library from.
LoadOptions library();

/// A solution as text, for comparing and for sorting.
struct Found {
  std::string value;
  std::vector<std::string> choices;  // "address = value", in the order in which they were met
  std::vector<std::string> printed;

  friend auto operator<=>(const Found&, const Found&) = default;
};

/// All solutions that an engine has, sorted.
std::vector<Found> all_solutions(SolutionStream& engine);

/// Exploring on demand with CaDiCaL or Z3, exploring at random, the dissertation's engine, or running every
/// execution.
enum class Way { kDemand, kZ3, kRandom, kThesis, kExhaustive };

/// All solutions of a program by one of the engines, sorted. kRandom and kThesis explore a number of random
/// executions, and may therefore miss some; for kDemand, other solvers confirm that there are no more. Throws
/// ProgramError.
std::vector<Found> all_solutions(const Program& program, const ParamValues& params, Way way);

/// All solutions by running every execution, sorted; nothing if there are more than so many executions.
std::optional<std::vector<Found>> brute_force(const Program& program, const ParamValues& params,
                                              std::uint64_t most_executions);

/// Every execution that is no error, by counting through all choices; nothing if there are more than so many.
/// Values in them refer to the program. Throws ProgramError.
std::optional<std::vector<Execution>> all_executions(const Program& program, AddressTable& addresses,
                                                     const Limits& limits, std::uint64_t most = UINT64_MAX);

/// The execution with these choices, run on its own.
Execution run_again(const Program& program, const ParamValues& params, const ChosenValues& choices,
                    const Limits& limits);

/// The program of a script below tests/.
Program load(const std::string& path);

/// The program of a text.
Program program_of(const std::string& text);

/// The values of all solutions, sorted, by exploration on demand; checked to be the same by the exhaustive
/// engine.
std::vector<std::string> values_of(const std::string& text);

}  // namespace solitaire
