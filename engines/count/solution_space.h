#pragma once
#include <atomic>
#include <map>
#include <memory>
#include <set>

#include "engines/count/nested/nested_sampler.h"
#include "engines/count/nested/tuning.h"
#include "engines/solve/executions/meeting.h"
#include "engines/solve/executions/traced_program.h"
#include "smt/sat/bit_blast.h"
#include "smt/xor/projected_models.h"

namespace solitaire {

/// Choices of a program that no condition ties to its other choices. What they can be together does not
/// depend on the others, so that the solutions of a program are all combinations of what its parts can be.
class SpacePart {
 public:
  /// The conditions depend on these variables and no others.
  SpacePart(const Graph& graph, std::vector<std::size_t> variables, std::vector<NodeId> conditions);

  const std::vector<std::size_t>& variables() const { return variables_; }
  const std::vector<NodeId>& conditions() const { return conditions_; }

  /// Returns how many values the part has if it is a single choice without conditions; else nothing.
  std::optional<std::uint64_t> free_values() const;
  /// The value of that choice with this number, from 0.
  std::int64_t free_value(std::uint64_t number) const;

  /// Returns the number of bits in a model.
  std::size_t bits() { return models().bits(); }
  /// Lists what the choices can be, as ProjectedModels::find. Throws Interrupted.
  std::vector<BitModel> find(std::span<const XorConstraint> parities, std::size_t most,
                             const StopSignal& stop, std::atomic<std::uint64_t>* found = nullptr) {
    return models().find(parities, most, stop, found);
  }
  /// Counts what the choices can be by going through them, up to `most`, and keeps `found` up with that.
  /// Returns nothing where that is too hard. Throws Interrupted.
  std::optional<std::uint64_t> enumerate(std::uint64_t most, const StopSignal& stop,
                                         std::atomic<std::uint64_t>& found) const;
  /// Returns nothing where NestedSampler::prepared does, or the choices cannot be put into clusters. Throws
  /// Interrupted.
  std::optional<NestedSampler> nested_sampler(RandomStream random, const StopSignal& stop,
                                              const NestedLimits& limits = {}) const;
  /// The values of the choices that a model stands for.
  void decode(const BitModel& model, VariableValues& values) const;

 private:
  struct Compiled;
  const ProjectedModels& models();

  const Graph* graph_;
  std::vector<std::size_t> variables_;
  std::vector<NodeId> conditions_;
  std::shared_ptr<Compiled> compiled_;  // once it is needed
};

/// All solutions of a program as values of the choices' variables: each solution is exactly one of them.
/// Auxiliary choices make no solutions different, and have their lowest values here. A choice that a solution
/// does not meet has its lowest value, or else a path with fewer choices would count more often.
class SolutionSpace {
 public:
  /// Every path that an execution can take has to be explored.
  explicit SolutionSpace(TracedProgram& program);

  std::vector<SpacePart>& parts() { return parts_; }
  /// The parts with these numbers become one, the last.
  void join(const std::vector<std::size_t>& numbers);
  /// The lowest value of each choice.
  VariableValues lowest() const;
  /// Returns the values that stand for the solution with these choices.
  VariableValues values_of(const ChosenValues& choices) const;
  /// The numbers of the auxiliary choices' variables, which are in no part.
  const std::set<std::size_t>& auxiliary() const { return auxiliary_; }

 private:
  const Graph& graph_;
  AddressTable& addresses_;
  MeetingConditions meeting_;
  std::set<std::size_t> auxiliary_;
  std::vector<SpacePart> parts_;
};

}  // namespace solitaire
