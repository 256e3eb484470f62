#include "engines/sample/shred/known_paths.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "engines/errors.h"
#include "engines/sample/shred/block_passages.h"
#include "engines/tuning.h"

namespace solitaire {

TracedStructure* KnownPaths::structure_of(const SampledState& state, AddressTable& addresses,
                                          const TracedStructure* kept) {
  TracedStructure* found = find(state, kept);
  if (found == nullptr && !refused_) {
    try {
      found = add(trace_structure(program_, params_, state, addresses, limits_, returned_));
      if (!found->load(state)) throw InternalError("a trace does not take the path of its own execution");
    } catch (const ProgramError& error) {
      refused_ = error.diagnostics().front();
    }
  }
  if (found != nullptr) check_density(found->kernel, state);
  return found;
}

void KnownPaths::end_warmup() {
  if (structures_.size() > tuning::kMostPassages) return;
  for (std::size_t i = 0; i < structures_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) let_draw_block(*structures_[i], *structures_[j]);
}

bool KnownPaths::full() const { return structures_.size() >= tuning::kMostTraces; }

TracedStructure* KnownPaths::find(const SampledState& state, const TracedStructure* kept) const {
  for (const auto& each : structures_)
    if (each.get() != kept && each->load(state)) return each.get();
  return nullptr;
}

void KnownPaths::use(const TracedStructure* structure) {
  const auto found = std::find_if(structures_.begin(), structures_.end(),
                                  [&](const auto& each) { return each.get() == structure; });
  std::rotate(structures_.begin(), found, found + 1);
}

/// It comes second, so that the one in use stays first.
TracedStructure* KnownPaths::add(TracedStructure made) {
  if (full()) drop_last();
  const auto place = structures_.begin() + (structures_.empty() ? 0 : 1);
  return structures_.insert(place, std::make_unique<TracedStructure>(std::move(made)))->get();
}

void KnownPaths::drop_last() {
  for (const auto& each : structures_) each->passages.forget(structures_.back().get());
  dropped_infinities_ += structures_.back()->kernel.infinities();
  structures_.pop_back();
}

std::uint64_t KnownPaths::infinities() const {
  std::uint64_t sum = dropped_infinities_;
  for (const auto& each : structures_) sum += each->kernel.infinities();
  return sum;
}

void check_density(const Kernel& kernel, const SampledState& run) {
  const double traced = kernel.log_score();
  const double size = 1 + std::abs(run.log_prior) + std::abs(run.log_weight);
  if (std::abs(traced - run.log_density()) <= tuning::kDensityTolerance * size) return;
  throw InternalError(
      fmt::format("the trace of an execution has the log density {}, and the execution has {}", traced,
                  run.log_density()));
}

}  // namespace solitaire
