#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "engines/sample/chain.h"
#include "engines/sample/draw_table.h"
#include "solitaire/run/evaluator.h"

namespace solitaire {

/// A program, which chains share, and params that a chain has for itself: values count who holds them without
/// regard to other threads.
struct ChainProgram {
  const Program* program = nullptr;
  const ParamValues* params = nullptr;
};

struct SamplingOptions {
  enum class Engine : std::uint8_t { kShred, kLightweight };
  Engine engine = Engine::kShred;
  std::uint64_t seed = 0;
  std::uint64_t draws = 1000;   // that are kept of each chain
  std::uint64_t warmup = 1000;  // draws of each chain before these, which are thrown away
  std::uint64_t thin = 1;       // sweeps from one draw to the next
  /// Whether executions all of whose choices are drawn anew are proposed, too. Tests leave them out to see
  /// what the other moves do: they alone make draws of programs that observe nothing independent.
  bool restarts = true;
  Limits limits;
};

/// What came of chains that ran side by side.
struct ChainResult {
  DrawTable draws;
  MoveCounts moves;
  Troubles troubles;
  std::optional<Diagnostic> slowed_by;  // see Chain
  bool stopped = false;                 // by the limits' stop signal, before all draws were there
};

/// Is told of draws while chains run, from any of their threads.
struct DrawListener {
  std::function<void()> drawn;  // after each draw, those of the warm-up included
  /// The number of a chain, from 0, and the numbers of a draw that is kept, with their names. May be empty.
  std::function<void(std::size_t, const std::vector<std::string>&, const std::vector<double>&)> kept = {};
  std::function<void(std::size_t)> ended = {};  // the number of a chain that gives no more. May be empty.
};

/// Runs one chain for each program, each on a thread for it, at most `jobs` at a time. What comes does not
/// depend on how many these are. Throws what a chain throws, the first by number, but for Interrupted.
std::vector<ChainResult> run_chains(const std::vector<ChainProgram>& programs, const SamplingOptions& options,
                                    std::size_t jobs, const DrawListener& listener);

}  // namespace solitaire
