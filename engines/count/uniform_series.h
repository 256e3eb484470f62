#pragma once
#include <atomic>

#include "engines/count/uniform.h"
#include "engines/distinct.h"
#include "engines/solve/solution_source.h"

namespace solitaire {

/// The solutions that a UniformEngine draws, on request without those that look like earlier ones: then each
/// look comes with a probability in proportion to the solutions that have it and are left.
class UniformSeries : public SolutionSource {
 public:
  UniformSeries(const Program& program, const ParamValues& params, const TracingOptions& tracing,
                bool distinct_results, const UniformOptions& uniform = {})
      : engine_(program, params, tracing, uniform), distinct_results_(distinct_results) {}

  std::vector<Solution> resume(const std::vector<KnownChoices>& earlier) override;
  bool catch_up() override { return true; }
  void explore() override { engine_.explore(); }
  /// As UniformEngine::next.
  std::optional<Solution> next() override;
  void on_improvement(std::function<void(const Solution&)>) override {}

  Ending ending() const override { return engine_.ending(); }
  TracingEngine& engine() override { return engine_.tracing(); }
  const TracingEngine& engine() const override { return engine_.tracing(); }
  std::uint64_t alike() const override { return alike_; }

 private:
  UniformEngine engine_;
  bool distinct_results_;
  DistinctResults results_;
  std::atomic<std::uint64_t> alike_ = 0;
};

}  // namespace solitaire
