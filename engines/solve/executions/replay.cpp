#include "engines/solve/executions/replay.h"

#include <algorithm>
#include <bit>
#include <fmt/format.h>

#include "engines/distinct.h"
#include "engines/errors.h"
#include "engines/freeze.h"
#include "engines/solve/executions/exclusion.h"
#include "solitaire/run/trace_reading.h"

namespace solitaire {
namespace {

/// Answers choices with known values. A choice without one, or whose value cannot be its, is handed to
/// `missing`, which throws.
template <class Missing>
class KnownValues : public Choices {
 public:
  KnownValues(const Valuation& values, Missing missing) : values_(values), missing_(missing) {}

  std::optional<TypedScalar> answer(AddressId address, const Distribution& domain) override {
    const auto value = values_.find(address);
    if (value == values_.end() || value->second.type() != domain.type()) missing_(address);
    return value->second;
  }

 private:
  const Valuation& values_;
  Missing missing_;
};

bool is_power_of_16(std::uint64_t number) {
  return std::has_single_bit(number) && std::countr_zero(number) % 4 == 0;
}

Limits limits_of(const TracingOptions& options) {
  Limits limits = options.limits;
  limits.keep_going = options.relax;
  return limits;
}

bool same_choices(const Execution& read, const Execution& run) {
  return std::ranges::equal(read.choices, run.choices, [](const MetChoice& a, const MetChoice& b) {
    return a.address == b.address && a.value == b.value;
  });
}

}  // namespace

Replayer::Replayer(const Program& program, const ParamValues& params, const TracingOptions& options,
                   ExecutionSolver& solver, std::uint64_t taken)
    : program_(program),
      solver_(solver),
      executor_(program, params, solver.addresses(), limits_of(options)),
      may_read_(options.replay == Replay::kSome && !options.relax && options.method->trusts_trace()),
      with_scene_(options.scene != SceneDetail::kNone),
      taken_(taken) {}

Execution Replayer::execution(Assignment& assignment) {
  std::optional<Execution> read = this->read(assignment);
  if (read && !is_power_of_16(taken_)) return std::move(*read);
  const TracedChoices met = solver_.met(assignment);
  if (read) {
    compare_with_run(*read, met.values);
    return std::move(*read);
  }
  Execution execution = run(met.values);
  if (const auto& rejection = execution.rejection) {
    throw InternalError(
        fmt::format("a model fails in its replay at {}", program_.sources.place(rejection->span)));
  }
  if (execution.choices.size() != met.values.size()) {
    throw InternalError(
        fmt::format("a model has {} choices, its replay {}", met.values.size(), execution.choices.size()));
  }
  return execution;
}

Execution Replayer::execution(const ChosenValues& choices) {
  Valuation values;
  for (const ChosenValue& choice : choices)
    values.emplace(solver_.addresses().address(choice.address), choice.value);
  std::optional<Execution> read = this->read(values);
  Execution execution = read ? std::move(*read) : run_written(values);
  if (execution.rejection) throw NotASolution("a condition of the program does not hold");
  if (execution.choices.size() != choices.size())
    throw NotASolution("it has choices that the program does not have");
  return execution;
}

/// Returns nothing if the execution has to be run instead.
std::optional<Execution> Replayer::read(Assignment& assignment) {
  const bool first = ++taken_ == 1;
  if (first || !may_read_) return std::nullopt;
  const Stopwatch watch(solver_.times().replay);
  return read_execution(program_, solver_.pass(), solver_.addresses(), assignment, with_scene_);
}

/// Returns nothing, too, where the values are not exactly those of the choices that the execution meets.
std::optional<Execution> Replayer::read(const Valuation& values) {
  bool possible = true;
  Assignment assignment = assignment_of(solver_.graph(), values, &possible);
  std::optional<Execution> execution = read(assignment);
  const auto known = [&](const MetChoice& choice) {
    const auto value = values.find(choice.address);
    return value != values.end() && value->second == choice.value;
  };
  if (!possible || !execution || execution->choices.size() != values.size() ||
      !std::ranges::all_of(execution->choices, known))
    return std::nullopt;
  if (is_power_of_16(taken_)) compare_with_run(*execution, values);
  return execution;
}

/// Nobody should believe what is never looked at: what is read is compared with a run, now and then.
void Replayer::compare_with_run(const Execution& read, const Valuation& values) {
  const Execution ran = run(values);
  const bool alike = !ran.rejection && same_choices(read, ran) && read.cost == ran.cost;
  const AddressTable& addresses = solver_.addresses();
  const Solution a = solution_of(read, addresses), b = solution_of(ran, addresses);
  if (!alike || to_json(a.value) != to_json(b.value) || (with_scene_ && looks_of(a) != looks_of(b)))
    throw InternalError("a solution is not what the trace says of it");
}

Execution Replayer::run(const Valuation& values) {
  KnownValues choices(values, [this](AddressId address) {
    throw InternalError("the replay met a choice that the model does not have: " +
                        solver_.addresses().text(address));
  });
  return run(choices);
}

std::optional<Diagnostic> Replayer::error_of(const Valuation& values) {
  struct NoMoreChoices {};
  KnownValues choices(values, [](AddressId) { throw NoMoreChoices{}; });
  try {
    run(choices);
  } catch (const NoMoreChoices&) {
  } catch (const ProgramError& error) {
    return error.diagnostics().front();
  }
  return std::nullopt;
}

Execution Replayer::run_written(const Valuation& values) {
  KnownValues choices(values, [this](AddressId address) {
    throw NotASolution("it has no choice " + solver_.addresses().text(address));
  });
  return run(choices);
}

Execution Replayer::run(Choices& choices) {
  const Stopwatch watch(solver_.times().replay);
  ++solver_.times().replays;
  Execution execution = std::move(executor_.run(choices));
  add_texts(execution, program_, solver_.addresses());
  return execution;
}

}  // namespace solitaire
