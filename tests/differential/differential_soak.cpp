// Compares the engines on generated programs for as long as it is told:
//
//   differential_soak MINUTES [FIRST-SEED]
//   differential_soak --show SEED
//   differential_soak --check FILE.sol
//
// tests/reference/reducer.py makes a program smaller for which --check fails.
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "tests/differential/differential.h"
#include "tests/generator/program_generator.h"

namespace {

using namespace solitaire;
using Clock = std::chrono::steady_clock;

/// "step limit of" or "demand: missed the solution": without the place of an error, and what names and
/// numbers change.
std::string kind_of_failure(const std::string& report) {
  static const std::regex kPlace(R"(^\S+:\d+:\d+: )");
  const std::string what = std::regex_replace(report, kPlace, "");
  return what.substr(0, what.find_first_of("0123456789\"=->", what.find(':') + 1));
}

SourceText read_file(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {path.filename().string(), {std::istreambuf_iterator<char>(in), {}}};
}

/// A script with the generated files that stand beside it.
GeneratedProgram read_program(const std::filesystem::path& script) {
  GeneratedProgram program{{read_file(script)}};
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::absolute(script).parent_path())) {
    if (entry.path().filename().string().rfind("part_", 0) == 0)
      program.files.push_back(read_file(entry.path()));
  }
  return program;
}

int soak(double minutes, std::uint64_t seed) {
  const auto end = Clock::now() + std::chrono::duration<double>(60 * minutes);
  std::uint64_t programs = 0, compared = 0, executions = 0, solutions = 0, with_errors = 0, failures = 0;
  std::uint64_t without_solutions = 0, incomplete = 0;
  std::map<std::string, int> skipped;
  for (; Clock::now() < end && failures < 20; ++seed) {
    ByteSource bytes(seed);
    const GeneratedProgram program = generate_program(bytes);
    ++programs;
    try {
      const Comparison result = compare_engines(program, seed);
      compared += result.outcome != Comparison::Outcome::kSkipped;
      executions += result.executions;
      solutions += result.solutions;
      with_errors += result.errors > 0;
      without_solutions += result.solutions == 0;
      incomplete += result.incomplete;
      if (result.outcome == Comparison::Outcome::kSkipped) ++skipped[kind_of_failure(result.report)];
      if (result.outcome != Comparison::Outcome::kDifferent) continue;
      ++failures;
      std::cout << fmt::format("seed {}: {}\n{}\n", seed, result.report, to_text(program)) << std::flush;
    } catch (const ProgramError& error) {
      ++failures;
      std::cout << fmt::format("seed {} makes no program: {}\n{}\n", seed, error.what(), to_text(program))
                << std::flush;
    }
  }
  std::cout << fmt::format(
      "{} programs to seed {}, {} compared: {} executions, {} solutions; {} programs with errors, {} without "
      "solutions, {} that random exploration did not cover; {} failures\n",
      programs, seed, compared, executions, solutions, with_errors, without_solutions, incomplete, failures);
  for (const auto& [why, count] : skipped) std::cout << fmt::format("skipped {}: {}\n", count, why);
  return failures > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 2 && arguments[0] == "--show") {
    ByteSource bytes(std::stoull(arguments[1]));
    std::cout << to_text(generate_program(bytes));
  } else if (arguments.size() == 2 && arguments[0] == "--check") {
    const Comparison result = compare_engines(read_program(arguments[1]), 1);
    std::cout << fmt::format("{} {} executions, {} solutions, {} errors\n", result.report, result.executions,
                             result.solutions, result.errors);
    return result.outcome == Comparison::Outcome::kDifferent ? 1 : 0;
  } else if (arguments.size() == 1 || arguments.size() == 2) {
    return soak(std::stod(arguments[0]), arguments.size() > 1 ? std::stoull(arguments[1]) : 1);
  } else {
    std::cerr << "usage: differential_soak MINUTES [FIRST-SEED] | --show SEED | --check FILE\n";
    return 2;
  }
  return 0;
}
