#include "engines/sample/sampling.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>

#include "base/large_stack.h"
#include "engines/sample/lightweight.h"
#include "engines/sample/returned_numbers.h"
#include "engines/sample/shred/shred.h"

namespace solitaire {
namespace {

std::unique_ptr<Chain> make_chain(const ChainProgram& own, const SamplingOptions& options,
                                  std::size_t number) {
  if (options.engine == SamplingOptions::Engine::kShred)
    return std::make_unique<ShredChain>(*own.program, *own.params, options.limits, options.seed, number,
                                        Restarts(options.restarts));
  return std::make_unique<LightweightChain>(*own.program, *own.params, options.limits, options.seed, number,
                                            Restarts(options.restarts));
}

/// One chain from its start to its last draw.
void run_chain(const ChainProgram& own, const SamplingOptions& options, std::size_t number,
               const DrawListener& listener, const std::function<bool()>& in_vain, ChainResult& result) {
  const auto look_for_stop = [&] {
    if (options.limits.stop != nullptr && options.limits.stop->stopped()) throw Interrupted{};
    if (in_vain()) throw Interrupted{};
  };
  look_for_stop();
  const ReturnedNumbers returned(*own.program);
  const std::unique_ptr<Chain> chain = make_chain(own, options, number);
  const auto draw = [&] {
    for (std::uint64_t i = 0; i < options.thin; ++i) {
      look_for_stop();
      chain->sweep();
    }
    listener.drawn();
  };
  for (std::uint64_t i = 0; i < options.warmup; ++i) draw();
  chain->end_warmup();
  const auto account = [&] {
    result.moves = chain->moves();
    result.troubles = chain->troubles();
    result.slowed_by = chain->slowed_by();
  };
  std::vector<std::string> names;
  std::vector<double> numbers;
  try {
    for (std::uint64_t i = 0; i < options.draws; ++i) {
      draw();
      names.clear();
      numbers.clear();
      chain->read(returned, names, numbers);
      result.draws.add(names, numbers);
      if (listener.kept) listener.kept(number, names, numbers);
    }
  } catch (const Interrupted&) {
    account();
    throw;
  }
  account();
}

class ChainRuns {
 public:
  ChainRuns(const std::vector<ChainProgram>& programs, const SamplingOptions& options,
            const DrawListener& listener)
      : programs_(programs),
        options_(options),
        listener_(listener),
        results_(programs.size()),
        errors_(programs.size()) {}

  /// Runs chains that nobody has begun until there are none.
  void work() {
    for (std::size_t i = next_++; i < programs_.size(); i = next_++) {
      try {
        run_chain(
            programs_[i], options_, i, listener_, [&] { return failed_ < i; }, results_[i]);
      } catch (const Interrupted&) {
        results_[i].stopped = true;
      } catch (...) {
        errors_[i] = std::current_exception();
        fail(i);
      }
      end(i);
    }
  }

  std::vector<ChainResult> results() {
    for (const std::exception_ptr& error : errors_)
      if (error) std::rethrow_exception(error);
    return std::move(results_);
  }

 private:
  /// What the listener throws ends the run as what a chain throws does.
  void end(std::size_t chain) {
    if (!listener_.ended) return;
    try {
      listener_.ended(chain);
    } catch (...) {
      if (!errors_[chain]) errors_[chain] = std::current_exception();
      fail(chain);
    }
  }

  /// The error of the chain with the least number is what is thrown: those with larger ones run in vain.
  void fail(std::size_t chain) {
    for (std::size_t least = failed_; chain < least;)
      if (failed_.compare_exchange_weak(least, chain)) return;
  }

  const std::vector<ChainProgram>& programs_;
  const SamplingOptions& options_;
  const DrawListener& listener_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<std::size_t> failed_ = SIZE_MAX;
  std::vector<ChainResult> results_;
  std::vector<std::exception_ptr> errors_;
};

}  // namespace

std::vector<ChainResult> run_chains(const std::vector<ChainProgram>& programs, const SamplingOptions& options,
                                    std::size_t jobs, const DrawListener& listener) {
  ChainRuns runs(programs, options, listener);
  {
    std::vector<std::unique_ptr<LargeStackThread>> threads;
    for (std::size_t i = 0; i < std::min(std::max<std::size_t>(jobs, 1), programs.size()); ++i)
      threads.push_back(std::make_unique<LargeStackThread>([&] { runs.work(); }));
  }
  return runs.results();
}

}  // namespace solitaire
