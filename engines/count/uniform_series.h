#pragma once
#include <atomic>
#include <vector>

#include "engines/count/uniform.h"
#include "engines/distinct.h"
#include "engines/solution_stream.h"

namespace solitaire {

/// The solutions that a UniformEngine draws, on request without those that look like earlier ones: then each
/// look comes with a probability in proportion to the solutions that have it and are left.
class UniformSeries : public SolutionStream,
                      public Resumable,
                      public Exploring,
                      public CountingAlike,
                      public Timed {
 public:
  UniformSeries(const Program& program, const ParamValues& params, const TracingOptions& tracing, Apart apart,
                const UniformOptions& uniform = {})
      : engine_(program, params, tracing, uniform), apart_(apart), results_(apart) {}

  std::vector<Solution> resume(const std::vector<ChosenValues>& earlier) override;
  bool catch_up() override { return true; }
  void explore() override { engine_.explore(); }
  /// Returns the next solution, see UniformEngine::next.
  std::optional<Solution> next() override;
  Ending ending() const override { return engine_.ending(); }
  std::size_t graph_size() const override { return engine_.graph_size(); }
  EngineTimes times() const override { return engine_.times(); }
  std::uint64_t alike() const override { return alike_; }
  bool names_differed() const override { return results_.names_differed(); }

 private:
  UniformEngine engine_;
  Apart apart_;
  DistinctResults results_;
  std::atomic<std::uint64_t> alike_ = 0;
};

}  // namespace solitaire
