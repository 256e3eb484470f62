#include "bench/tiles/runs.h"

#include <chrono>
#include <ctime>
#include <stop_token>
#include <thread>

namespace solitaire::tiles::bench {

double processor_seconds() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

namespace {

/// Stops a sampler that has had its time of the processor, so that figures do not depend on what else runs.
void stop_after(double seconds, StopSignal& stop, const std::stop_token& done) {
  const double end = processor_seconds() + seconds;
  while (!done.stop_requested() && processor_seconds() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  stop.request();
}

}  // namespace

Runs run(const Problem& problem, const SamplerOptions& options, std::size_t maps, double limit) {
  Runs runs;
  const double start = processor_seconds();
  const std::vector<TileMask> domains = consistent_domains(problem);
  for (std::uint64_t number = 1; number <= maps; ++number) {
    StopSignal stop;
    const std::jthread watch([&stop, limit](const std::stop_token& done) { stop_after(limit, stop, done); });
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
