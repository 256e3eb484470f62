#include "bench/tiles/runs.h"

#include <chrono>
#include <ctime>

namespace solitaire::tiles::bench {

double processor_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Runs run(const Problem& problem, const SamplerOptions& options, std::size_t maps, double limit) {
  Runs runs;
  const double start = processor_seconds();
  const std::vector<TileMask> domains = consistent_domains(problem);
  for (std::uint64_t number = 1; number <= maps; ++number) {
    StopSignal stop;
    stop.set_deadline(StopSignal::Clock::now() +
                      std::chrono::milliseconds(static_cast<std::int64_t>(1000 * limit)));
    ++runs.tried;
    Sample sample = draw_sample(problem, domains, options, number, stop);
    if (sample.outcome == Outcome::kFound) runs.maps.push_back(std::move(sample.map));
  }
  runs.seconds = processor_seconds() - start;
  return runs;
}

SamplerOptions options_of(SamplerKind kind, std::uint64_t burn_in, int blocks) {
  SamplerOptions options;
  options.kind = kind;
  options.burn_in = burn_in;
  options.largest_block = blocks;
  return options;
}

}  // namespace solitaire::tiles::bench
