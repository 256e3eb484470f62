#include "engines/tiles/job/job.h"

#include <chrono>
#include <doctest/doctest.h>

#include "base/stop_signal.h"

namespace solitaire::tiles {
namespace {

using Clock = std::chrono::steady_clock;

/// A wish to stop that comes a while after this was made.
struct StopSoon {
  Clock::time_point at = Clock::now() + std::chrono::milliseconds(100);
  bool operator()() const { return Clock::now() >= at; }
};

JobOptions streets(int width, int height) {
  JobOptions options;
  options.inputs = {SOLITAIRE_SOURCE_DIR "/examples/tiles/urban.txt"};
  options.width = width;
  options.height = height;
  options.weights = WeightsKind::kStep;
  return options;
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

TEST_CASE("every sampler ends when it is asked to") {
  for (const SamplerKind kind :
       {SamplerKind::kWindows, SamplerKind::kBlockSs, SamplerKind::kWfc, SamplerKind::kRaster,
        SamplerKind::kMh, SamplerKind::kGibbs, SamplerKind::kSearch}) {
    CAPTURE(static_cast<int>(kind));
    JobOptions options = streets(150, 150);
    options.sampling.kind = kind;
    options.sampling.effort = UINT64_MAX;
    options.maps = 1'000'000;
    options.jobs = 2;
    const auto start = Clock::now();
    CHECK(Job(options, StopSoon()).run([](std::uint64_t) {}) == JobEnding::kStopped);
    CHECK(seconds_since(start) < 5);
  }
}

TEST_CASE("what came before a stop is kept") {
  JobOptions options = streets(6, 6);
  options.maps = 1'000'000;
  std::uint64_t delivered = 0;
  Job job(options, [&] { return delivered >= 3; });
  CHECK(job.run([&](std::uint64_t number) { delivered = number; }) == JobEnding::kStopped);
  CHECK(delivered >= 3);
  CHECK(job.summary().starts_with(std::to_string(delivered) + " maps of 6x6"));
}

TEST_CASE("of a single map it is told as of one") {
  Job job(streets(6, 6));
  CHECK(job.run([](std::uint64_t) {}) == JobEnding::kDone);
  CHECK(job.summary().starts_with("1 map of 6x6, "));
}

TEST_CASE("fitting, counting and explaining end when they are asked to") {
  JobOptions fitted = streets(20, 20);
  fitted.weights = WeightsKind::kFitted;
  CHECK(Job(fitted, StopSoon()).run([](std::uint64_t) {}) == JobEnding::kStopped);
  CHECK_THROWS_AS(Job(streets(14, 1000), StopSoon()).count(), Interrupted);
  CHECK_THROWS_AS(Job(streets(300, 300), StopSoon()).explain(), Interrupted);
}

TEST_CASE("the examples make maps") {
  for (const std::string name : {"facade", "frame", "pipes", "platforms", "railway", "suburb", "urban"}) {
    CAPTURE(name);
    JobOptions options;
    options.inputs = {SOLITAIRE_SOURCE_DIR "/examples/tiles/" + name + ".tiles.json"};
    options.weights = WeightsKind::kStep;
    if (name == "railway") options.width = options.height = 10;
    if (name == "pipes" || name == "platforms") options.width = options.height = 18;
    options.sampling.anneal = 2;
    options.sampling.sweeps = 1;
    CHECK(Job(options).run([](std::uint64_t) {}) == JobEnding::kDone);
  }
}

}  // namespace
}  // namespace solitaire::tiles
