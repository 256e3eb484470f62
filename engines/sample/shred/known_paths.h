#pragma once
#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/diagnostic.h"
#include "engines/sample/shred/traced_structure.h"

namespace solitaire {

/// The paths of a program that a chain has traced.
class KnownPaths {
 public:
  /// The program and the params have to outlive it.
  KnownPaths(const Program& program, const ParamValues& params, const Limits& limits)
      : program_(program), params_(params), limits_(limits), returned_(program) {}

  /// The structure of the path that the state takes, with its values. It is traced if it was not; then the
  /// one that was not used the longest is dropped where there are too many. Nothing where a trace cannot say
  /// what the program does. `kept` is a structure of another path, which keeps its values.
  TracedStructure* structure_of(const SampledState& state, AddressTable& addresses,
                                const TracedStructure* kept = nullptr);

  /// Says that the structure is used.
  void use(const TracedStructure* structure);
  /// The last ones that were used, the very last first.
  std::span<const std::unique_ptr<TracedStructure>> latest(std::size_t most) const {
    return {structures_.data(), std::min(most, structures_.size())};
  }
  /// Lets passages draw blocks from now on, where the paths are few. It stays the same from then on which do,
  /// so that each step is as probable as the one back.
  void end_warmup();
  bool full() const;
  /// Why something could not be traced. From then on nothing is.
  const std::optional<Diagnostic>& refused() const { return refused_; }
  /// How often a density was infinite.
  std::uint64_t infinities() const;

 private:
  TracedStructure* find(const SampledState& state, const TracedStructure* kept) const;
  TracedStructure* add(TracedStructure made);
  void drop_last();

  const Program& program_;
  const ParamValues& params_;
  Limits limits_;
  ReturnedNumbers returned_;
  std::vector<std::unique_ptr<TracedStructure>> structures_;  // the one that was used last first
  std::optional<Diagnostic> refused_;
  std::uint64_t dropped_infinities_ = 0;
};

/// Throws InternalError where the kernel does not give the density that the run of the execution gave.
void check_density(const Kernel& kernel, const SampledState& run);

}  // namespace solitaire
