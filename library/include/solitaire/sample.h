#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <solitaire/export.h>
#include <solitaire/options.h>
#include <solitaire/program.h>
#include <string>
#include <vector>

namespace solitaire::api {

struct SampleOptions : Options {
  enum class Engine : std::uint8_t {
    kShred,        // each step computes anew what depends on it, on the trace of the program
    kLightweight,  // each step runs the program again
  };
  Engine engine = Engine::kShred;
  std::uint64_t draws = 1000;  // that are kept, over all chains; rounded up to as many of each chain
  std::uint64_t chains = 4;
  /// Draws of each chain that come before these and are thrown away. By default as many as are kept of each
  /// chain, but no fewer than 500 and no more than 5000.
  std::optional<std::uint64_t> warmup;
  std::uint64_t thin = 1;  // sweeps over all choices from one draw to the next
  std::uint64_t jobs = 1;  // chains at work side by side; the draws are the same for any number
};

/// A draw that is kept: what the program returned in one execution. A number that it does not have is NaN.
struct SampledDraw {
  std::uint64_t chain = 1, draw = 1;  // both from 1
  std::vector<std::string> names;
  std::vector<double> numbers;  // one for each name
};

/// What the draws say about one number of the returned value. NaN stands for what they do not tell.
struct SampledNumber {
  std::string name;
  double mean = 0, sd = 0;
  double mcse = 0;  // the standard error of the mean that comes from drawing
  double q5 = 0, q50 = 0, q95 = 0;
  double ess_bulk = 0, ess_tail = 0;  // as many independent draws would say as much
  double rhat = 0;                    // 1 where the chains agree
};

/// How often steps of a kind were tried and taken, after the warm-up.
struct SampledMoves {
  std::string name;
  std::uint64_t tried = 0, accepted = 0;
};

struct SampleSummary {
  std::vector<SampledNumber> parameters;
  std::uint64_t chains = 0;
  std::uint64_t draws = 0;  // over all chains
  std::uint64_t steps = 0;  // after the warm-up
  double seconds = 0;       // with the warm-up
  double steps_per_second = 0;
  double acceptance = 0;  // the share of steps that were taken
  std::vector<SampledMoves> moves;
  std::vector<std::string> warnings;  // what is doubtful, and what to do about it
};

/// Returns a table for people, or one JSON object; the first with a newline at its end.
SOLITAIRE_API std::string to_text(const SampleSummary& summary);
SOLITAIRE_API std::string to_json(const SampleSummary& summary);

/// Returns one line without a newline: {"chain": ..., "draw": ..., "values": {...}}.
SOLITAIRE_API std::string to_json(const SampledDraw& draw);
/// Returns a row of a table without a newline, and the row of names that stands above it: chain, draw, and
/// the numbers. An empty cell is a number that the draw does not have.
SOLITAIRE_API std::string to_csv(const SampledDraw& draw);
SOLITAIRE_API std::string csv_names(const std::vector<std::string>& names);

/// Draws executions of a program by how probable they are.
class SOLITAIRE_API Sampler {
 public:
  /// Throws Error (kUsage).
  Sampler(const Program& program, const SampleOptions& options);
  ~Sampler();
  Sampler(const Sampler&) = delete;
  Sampler& operator=(const Sampler&) = delete;

  /// Draws until all draws are there, or a stop comes; then it keeps those that are there. `progress` is told
  /// how many there are, those of the warm-up included, and how many it takes; from any thread. Throws Error:
  /// kProgram for a mistake that an execution comes to. `kept` gets the draws in the order of chains and, in
  /// each, of draws, as soon as that order lets them; one at a time, from any thread.
  SampleSummary run(const std::function<void(std::uint64_t, std::uint64_t)>& progress = {},
                    const std::function<void(const SampledDraw&)>& kept = {});
  /// Writes the draws: as JSON lines, each by to_json(), if the file's name ends in ".jsonl", else as a table
  /// (.csv). Throws Error (kFile).
  void write_draws(const std::filesystem::path& path) const;
  /// Writes a page (.html) with the summary and pictures of the draws. Throws Error (kFile).
  void write_report(const std::filesystem::path& path, const SampleSummary& summary) const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace solitaire::api
