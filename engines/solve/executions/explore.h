#pragma once
#include <memory>
#include <vector>

#include "engines/tuning.h"
#include "solitaire/run/choices.h"
#include "solitaire/run/evaluator.h"

namespace solitaire {

/// Says which executions the trace graph is to cover.
struct Exploration {
  enum class Policy : std::uint8_t { kDemand, kRandom };
  Policy policy = Policy::kDemand;
  std::uint64_t executions = 0;  // kRandom: how many random executions open the sides that they take

  // kDemand: how many sides the first passes, and each later one, may open without being asked, and the fuel
  // of paths that only some executions take.
  std::size_t unasked_sides = tuning::kUnaskedSides;
  std::uint32_t levels = tuning::kFirstLevels;    // of the first pass; at least 1
  std::uint32_t grant = tuning::kFirstGrant;      // levels that come with the first sides asked for
  std::uint64_t fuel_steps = tuning::kFuelSteps;  // at least 1
  std::uint32_t fuel_depth = tuning::kFuelDepth;  // at least 1
};

/// Grows the trace graph of a program: passes over a growing set of open branch sides. The dissertation's
/// TraceExplore (section 4.3.1), made simpler: the graph is hash-consed, so a pass finds the nodes of the
/// passes before it.
///
/// Demand: the first passes open a few levels of undecided branches, each four times as many as the one
/// before, up to a budget of sides. Afterwards sides are opened that stood in the way of a solution, and with
/// each of them twice as many levels below as the time before, up to the same budget again. What is open
/// stays open, and costs no budget. Random (the dissertation's policy): the sides that
/// random executions take are open, and no others.
class Explorer {
 public:
  /// `choices` answers what is not to be left open.
  Explorer(const Program& program, ParamValues params, const Exploration& exploration, std::uint64_t seed,
           const Limits& limits, Choices& choices, Graph& graph, AddressTable& addresses);
  ~Explorer();

  /// The trace of the newest pass. Throws Interrupted.
  const SymbolicPass& pass() const { return pass_; }
  /// Runs the first passes.
  void start();
  /// Opens what these blockers of the newest pass closed, and runs a pass. Returns false if the policy does
  /// not allow it.
  bool open(const std::vector<std::size_t>& blockers);
  /// Runs a pass that joins paths with the steps of the shortest one, as all later ones do.
  void count_least_steps();
  bool counts_least_steps() const { return limits_.least_steps; }
  std::size_t passes() const { return passes_; }

 private:
  class OpenSides;
  void run_pass();
  void open_random_sides();

  const Program& program_;
  ParamValues params_;
  Exploration exploration_;
  std::uint64_t seed_;
  Limits limits_;   // of one execution
  Limits granted_;  // of a pass: with the fuel it was granted so far
  Choices& choices_;
  Graph& graph_;
  AddressTable& addresses_;
  std::unique_ptr<OpenSides> sides_;
  std::uint32_t grant_;  // levels that come with the next sides to be opened
  SymbolicPass pass_;
  std::size_t passes_ = 0;
};

}  // namespace solitaire
