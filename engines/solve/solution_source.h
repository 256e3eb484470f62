#pragma once
#include "engines/solve/tracing.h"

namespace solitaire {

/// The solutions of a program one after the other, as a user sees them, in whichever way they are chosen. A
/// source that was interrupted goes on with exactly the solutions that would have come, given those that
/// came.
class SolutionSource {
 public:
  virtual ~SolutionSource() = default;

  /// Goes on after these solutions; returns them, run again. To be called before anything else.
  /// Throws NotASolution, whose message names the one that is none, and Interrupted.
  virtual std::vector<Solution> resume(const std::vector<KnownChoices>& earlier) = 0;
  /// Does again what is needed to go on, which next() does, too, but then it counts as a search for one
  /// solution. False if a limit came first. Throws Interrupted.
  virtual bool catch_up() = 0;
  /// Explores, which is part of the search for the first. Throws Interrupted.
  virtual void explore() = 0;
  /// As TracingEngine::next.
  virtual std::optional<Solution> next() = 0;
  /// As TracingEngine::on_improvement.
  virtual void on_improvement(std::function<void(const Solution&)> told) = 0;

  /// Whether other threads are at work for it until it is destroyed.
  virtual bool has_threads() const { return false; }
  virtual Ending ending() const = 0;
  /// Of all searches so far, on whichever thread.
  virtual TracingTimes times() const { return engine().times(); }
  virtual TracingEngine& engine() = 0;
  virtual const TracingEngine& engine() const = 0;
  /// One that knows all solutions that came, and at the end that there are no others.
  virtual TracingEngine& engine_of_rest() { return engine(); }
  /// Solutions that were left out because they look like others. May be asked for from another thread.
  virtual std::uint64_t alike() const = 0;
};

/// Runs solutions that are known from before. Throws NotASolution, whose message names the one that is none,
/// and Interrupted.
std::vector<Solution> run_all(TracingEngine& engine, const std::vector<KnownChoices>& known);

}  // namespace solitaire
