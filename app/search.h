#pragma once
#include <functional>

#include "app/session.h"
#include "engines/distinct.h"

namespace solitaire {

/// Looks for as many solutions as the options ask for, and hands each to `found` as it comes, with its number
/// from 1. Shows progress while it runs and a summary at the end, both on standard error; there too goes what
/// solutions print.
class Search {
 public:
  using Found = std::function<void(std::uint64_t number, const Solution& solution)>;

  Search(const Session& session, const Options& options);
  ExitStatus run(const Found& found);

  const TracingEngine& engine() const { return engine_; }
  std::uint64_t solutions() const { return solutions_; }

 private:
  bool wants_more() const { return options_.all || solutions_ < options_.count; }
  ExitStatus status() const;
  void summarize() const;
  void explain_dead_end() const;

  const Session& session_;
  const Options& options_;
  TracingEngine engine_;
  DistinctResults results_;
  std::uint64_t solutions_ = 0;
  std::uint64_t alike_ = 0;  // solutions that looked like earlier ones
  StopSignal::Clock::time_point start_ = StopSignal::Clock::now();
};

}  // namespace solitaire
