#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engines/count/counting.h"

namespace CLI {
class App;
}

namespace solitaire {

/// Exit statuses of every subcommand.
enum ExitStatus : int {
  kDelivered = 0,   // what was asked for
  kNoSolution = 1,  // proved that there is no (further) solution where one was asked for
  kUsage = 2,
  kError = 3,  // in the program, or a file that cannot be read or written
  kLimit = 4,  // time, memory or an interrupt came first; what was found is kept
};

/// How hard to try for solutions that differ much.
enum class DiversityLevel : std::uint8_t { kLow, kNormal, kHigh };

/// How solutions are chosen among all: as the search finds them, or each with the same probability.
enum class Sampling : std::uint8_t { kSearch, kUniform };

enum class Distinct : std::uint8_t { kChoices, kResult };

/// What the command line asks for.
struct Options {
  std::string script;
  std::vector<std::string> settings;  // NAME=VALUE
  std::uint64_t seed = 0;
  std::uint64_t count = 1;
  std::uint64_t jobs = 1;  // searches at work at a time
  bool all = false;
  Replay replay = Replay::kSome;  // what is written to disk is always run
  Distinct distinct = Distinct::kChoices;
  std::optional<DiversityLevel> diversity;  // normal, with --all low
  Sampling sampling = Sampling::kSearch;
  double min_distance = 0;  // of choices, 0..1
  std::filesystem::path output = "out";
  bool json = false;
  bool timings = false;
  bool resume = false;
  bool deep = false;
  bool quiet = false;
  std::optional<double> timeout;       // seconds, for the whole run
  std::optional<double> per_solution;  // seconds, for one further solution
  std::optional<double> memory;        // megabytes, of the process
  std::optional<std::string> explore;  // as it was said; see exploration_name()
  Backend backend = Backend::kCadical;
  std::uint64_t max_steps = Limits{}.max_steps;
  std::uint32_t max_depth = Limits{}.max_depth;
  std::string format = "text";
  std::vector<std::string> pins;       // ADDRESS=VALUE
  std::vector<std::string> forbidden;  // ADDRESS=VALUE
  std::filesystem::path pin_file;
  std::vector<std::string> keep;  // patterns over the addresses of pin_file
  bool relax = false;
  std::uint64_t more = 0;  // conflicts after the first
  bool choices = false;    // explain every choice
  bool thorough = false;
  CountOptions counting;
  std::optional<std::filesystem::path> formula;  // where what is left at the end is written to

  /// How paths are explored: as --explore says, else by demand, and in the dissertation's engine by 100
  /// random executions.
  std::string exploration_name() const;
  Exploration exploration() const;
};

/// Adds the options that every subcommand shares.
void add_program_options(CLI::App& command, Options& options);
/// Adds the options of the subcommands that solve: which solver, and what is held fixed.
void add_solver_options(CLI::App& command, Options& options);
/// Adds the options of the subcommands that look for solutions.
void add_search_options(CLI::App& command, Options& options);
/// Adds those of the subcommand that counts.
void add_count_options(CLI::App& command, Options& options);

}  // namespace solitaire
