// Compares the engines on generated programs for as long as it is told, and makes programs that fail smaller:
//
//   differential_soak MINUTES [FIRST-SEED]
//   differential_soak --show SEED
//   differential_soak --reduce FILE.sol
#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <vector>

#include "base/diagnostic.h"
#include "tests/differential.h"
#include "tests/program_generator.h"

namespace {

using namespace solitaire;
using Clock = std::chrono::steady_clock;
using Lines = std::vector<std::string>;

Lines split_lines(const std::string& text) {
  Lines lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string join_lines(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

/// "demand: missed the solution", without what names and numbers change.
std::string kind_of_failure(const std::string& report) {
  return report.substr(0, report.find_first_of("0123456789\"=->", report.find(':') + 1));
}

std::string failure(const Lines& lines) {
  try {
    const Comparison result = compare_engines(join_lines(lines), 1);
    return result.outcome == Comparison::Outcome::kDifferent ? kind_of_failure(result.report) : "";
  } catch (const ProgramError&) {
    return "";  // no program any more
  }
}

/// The line after the one that closes the block which `line` opens.
std::size_t end_of_block(const Lines& lines, std::size_t line) {
  const std::size_t indentation = lines[line].find_first_not_of(' ');
  std::size_t end = line + 1;
  while (end < lines.size() && lines[end].find_first_not_of(' ') > indentation) ++end;
  return std::min(end + 1, lines.size());
}

/// All that can be left out from a line on: the line, its block with or without what is in it.
std::vector<Lines> smaller_at(const Lines& lines, std::size_t at) {
  std::vector<Lines> result;
  const auto without = [&](std::size_t begin, std::size_t end) {
    Lines rest(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(begin));
    rest.insert(rest.end(), lines.begin() + static_cast<std::ptrdiff_t>(end), lines.end());
    return rest;
  };
  if (lines[at].empty() || lines[at].back() != '{') return {without(at, at + 1)};
  const std::size_t end = end_of_block(lines, at);
  result.push_back(without(at, end));
  Lines inner = lines;
  inner.erase(inner.begin() + static_cast<std::ptrdiff_t>(end) - 1);
  inner.erase(inner.begin() + static_cast<std::ptrdiff_t>(at));
  result.push_back(std::move(inner));
  return result;
}

Lines reduce(Lines lines) {
  const std::string wanted = failure(lines);
  for (bool smaller = true; smaller;) {
    smaller = false;
    for (std::size_t at = lines.size(); at-- > 0;) {
      if (at >= lines.size()) continue;
      for (Lines& candidate : smaller_at(lines, at)) {
        if (failure(candidate) != wanted) continue;
        lines = std::move(candidate);
        smaller = true;
        break;
      }
    }
  }
  return lines;
}

std::string read_file(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

int soak(double minutes, std::uint64_t seed) {
  const auto end = Clock::now() + std::chrono::duration<double>(60 * minutes);
  std::uint64_t programs = 0, compared = 0, executions = 0, solutions = 0, with_errors = 0, failures = 0;
  std::uint64_t without_solutions = 0, incomplete = 0;
  std::map<std::string, int> skipped;
  for (; Clock::now() < end && failures < 20; ++seed) {
    ByteSource bytes(seed);
    const std::string program = generate_program(bytes);
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
      std::cout << fmt::format("seed {}: {}\n{}\n", seed, result.report, program) << std::flush;
    } catch (const ProgramError& error) {
      ++failures;
      std::cout << fmt::format("seed {} makes no program: {}\n{}\n", seed, error.what(), program)
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
    std::cout << generate_program(bytes);
  } else if (arguments.size() == 2 && arguments[0] == "--reduce") {
    const Lines smallest = reduce(split_lines(read_file(arguments[1])));
    std::cout << join_lines(smallest) << "// " << compare_engines(join_lines(smallest), 1).report << "\n";
  } else if (arguments.size() == 2 && arguments[0] == "--check") {
    const Comparison result = compare_engines(read_file(arguments[1]), 1);
    std::cout << fmt::format("{} {} executions, {} solutions, {} errors\n", result.report, result.executions,
                             result.solutions, result.errors);
    return result.outcome == Comparison::Outcome::kDifferent ? 1 : 0;
  } else if (arguments.size() == 1 || arguments.size() == 2) {
    return soak(std::stod(arguments[0]), arguments.size() > 1 ? std::stoull(arguments[1]) : 1);
  } else {
    std::cerr
        << "usage: differential_soak MINUTES [FIRST-SEED] | --show SEED | --check FILE | --reduce FILE\n";
    return 2;
  }
  return 0;
}
