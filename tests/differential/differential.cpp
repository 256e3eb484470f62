#include "tests/differential/differential.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <set>
#include <stdexcept>
#include <vector>

#include "base/installation.h"
#include "engines/distinct.h"
#include "engines/exhaustive/exhaustive.h"
#include "engines/solve/tracing.h"
#include "solitaire/names/analyze.h"

namespace solitaire {
namespace {

constexpr std::uint64_t kMostExecutions = 1500;
constexpr std::uint64_t kMostSteps = 20'000;
constexpr std::uint32_t kMostDepth = 40;
constexpr auto kTimeOfAnEngine = std::chrono::seconds(20);
constexpr auto kTimeOfBruteForce = std::chrono::seconds(3);
constexpr const char* kRunsLong = "this runs for more than";
/// What the tracing engine may refuse though every execution is right. Its passes take the steps of all
/// branches.
constexpr const char* kBeyondEngine[] = {"past 62 bits", "depends on a float", "looks at what it says",
                                         kRunsLong};

bool is_beyond_engine(const std::string& error) {
  return std::any_of(std::begin(kBeyondEngine), std::end(kBeyondEngine),
                     [&](const char* part) { return error.find(part) != std::string::npos; });
}

/// Everything that a solution says.
std::string describe(const Solution& solution) {
  std::vector<std::string> choices;
  for (const ChosenValue& choice : solution.choices) {
    choices.push_back(fmt::format("{}={}", choice.address, to_text(choice.value)));
  }
  std::sort(choices.begin(), choices.end());
  std::string text = fmt::format("{} -> {}", fmt::join(choices, " "), to_json(solution.value));
  for (const PlacedObject& placed : solution.placements) {
    text +=
        fmt::format("\n    placed {} name {} from {} {} with {}", placed.address, json_string(placed.name),
                    placed.source, fmt::join(placed.calls, "/"), placed.extras.size());
  }
  text += fmt::format("\n    looks {} unit {}", fmt::join(looks_of(solution), "; "), solution.unit);
  for (const std::string& line : solution.printed) text += "\n    printed " + line;
  return text;
}

/// An address that two choices of one execution share, or "".
std::string shared_address(const Solution& solution) {
  std::set<std::string> seen;
  for (const ChosenValue& choice : solution.choices) {
    if (!seen.insert(choice.address).second) return choice.address;
  }
  return "";
}

std::string describe(const ProgramError& error, const SourceSet& sources) {
  const Diagnostic& first = error.diagnostics().front();
  return fmt::format("{}: {}", sources.place(first.span), first.message);
}

struct FoundResults {
  std::set<std::string> solutions;
  std::set<std::string> errors;
  std::string fault;  // what no engine may do
  Ending ending = Ending::kNone;
};

/// A folder that is there as long as this object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "solitaire-differential-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Loads a program that has one file from memory, one that imports others from a folder of its own.
Program load(const GeneratedProgram& program) {
  SourceSet unused;
  LoadOptions options;
  options.library_folders = {find_data_folder()};
  const SourceText& script = program.files.front();
  if (program.files.size() == 1) return load_program_text(script.name, script.text, options, unused);
  const TemporaryFolder folder;
  for (const SourceText& file : program.files) std::ofstream(folder.path() / file.name) << file.text;
  return load_program(folder.path() / script.name, options, unused);
}

class Comparer {
 public:
  Comparer(const GeneratedProgram& program, std::uint64_t seed) : program_(load(program)), seed_(seed) {
    limits_.max_steps = kMostSteps;
    limits_.max_depth = kMostDepth;
  }

  Comparison run() {
    run_all();
    if (!result_.report.empty()) return result_;
    Exploration little;
    little.unasked_sides = 0;
    little.levels = 1;
    little.grant = 0;
    little.fuel_steps = 8;
    little.fuel_depth = 1;
    Exploration some = little;
    some.unasked_sides = 3;
    some.levels = 2;
    some.grant = 1;
    Exploration random;
    random.policy = Exploration::Policy::kRandom;
    random.executions = 300;
    Exploration few = random;
    few.executions = 2;
    compare("demand", {});
    compare("demand, all in order", {}, false);
    compare("demand with nothing unasked", little);
    compare("demand with little unasked", some);
    compare("random:300", random);
    if (result_.outcome == Comparison::Outcome::kEqual) result_.incomplete = ending_ != Ending::kExhausted;
    compare("random:2", few);
    return result_;
  }

 private:
  void run_all() {
    StopSignal stop;
    stop.set_deadline(StopSignal::Clock::now() + kTimeOfBruteForce);
    Limits limits = limits_;
    limits.stop = &stop;
    ExhaustiveEngine engine(program_, {}, limits, kMostExecutions);
    while (engine.ending() == Ending::kNone) {
      try {
        const auto solution = engine.next();
        if (!solution) break;
        const std::string shared = shared_address(*solution);
        if (!shared.empty()) return differ("brute force", "two choices share the address " + shared);
        if (!expected_.solutions.insert(describe(*solution)).second) {
          return differ("brute force", "two executions look the same");
        }
      } catch (const ProgramError& error) {
        expected_.errors.insert(describe(error, program_.sources));
        if (std::string(error.what()).find(kRunsLong) != std::string::npos) return skip("runs for long");
      }
    }
    if (engine.ending() == Ending::kStopped) return skip("too many executions");
    result_.executions = engine.executions();
    result_.solutions = expected_.solutions.size();
    result_.errors = expected_.errors.size();
  }

  void compare(const std::string& name, const Exploration& exploration, bool diverse = true) {
    if (result_.outcome != Comparison::Outcome::kEqual) return;
    const FoundResults found = solve(exploration, diverse);
    ending_ = found.ending;
    if (!found.fault.empty()) return differ(name, found.fault);
    for (const std::string& error : found.errors) {
      if (expected_.errors.count(error) > 0) continue;
      if (is_beyond_engine(error)) {
        result_.refused = true;
        return skip(error);
      }
      return differ(name, "an error that no execution comes to: " + error);
    }
    for (const std::string& solution : found.solutions) {
      if (expected_.solutions.count(solution) == 0) return differ(name, "not a solution: " + solution);
    }
    if (!found.errors.empty()) return;
    if (found.ending == Ending::kStopped) return skip("an engine needs too much time");
    if (found.ending == Ending::kUnexplored && exploration.policy == Exploration::Policy::kRandom) return;
    if (found.ending != Ending::kExhausted) return differ(name, "it did not come to an end");
    if (!expected_.errors.empty()) return differ(name, "missed the error " + *expected_.errors.begin());
    for (const std::string& solution : expected_.solutions) {
      if (found.solutions.count(solution) == 0) return differ(name, "missed the solution " + solution);
    }
  }

  FoundResults solve(const Exploration& exploration, bool diverse) {
    StopSignal stop;
    stop.set_deadline(StopSignal::Clock::now() + kTimeOfAnEngine);
    TracingOptions options;
    options.exploration = exploration;
    options.seed = seed_;
    options.diverse = diverse;
    options.replay = Replay::kSome;  // so that what is read off the trace is compared, too
    options.limits = limits_;
    options.limits.stop = &stop;
    FoundResults found;
    try {
      TracingEngine engine(program_, {}, options);
      while (const auto solution = engine.next()) {
        const std::string text = describe(*solution);
        if (!found.solutions.insert(text).second) {
          found.fault = "found twice: " + text;
          return found;
        }
      }
      found.ending = engine.ending();
    } catch (const ProgramError& error) {
      found.errors.insert(describe(error, program_.sources));
    } catch (const std::exception& error) {  // InternalError, z3::exception, std::logic_error
      found.fault = error.what();
    }
    return found;
  }

  void skip(const std::string& why) {
    result_.outcome = Comparison::Outcome::kSkipped;
    result_.report = why;
  }

  void differ(const std::string& name, const std::string& what) {
    result_.outcome = Comparison::Outcome::kDifferent;
    result_.report = fmt::format("{}: {}", name, what);
  }

  Program program_;
  std::uint64_t seed_;
  Limits limits_;
  FoundResults expected_;
  Ending ending_ = Ending::kNone;
  Comparison result_;
};

}  // namespace

Comparison compare_engines(const GeneratedProgram& program, std::uint64_t seed) {
  return Comparer(program, seed).run();
}

}  // namespace solitaire
