// What chapter 3 of the dissertation measures in its figures 3.3 to 3.6, for the models of
// examples/sampling/: steps in a second by running the program again, by computing all of its trace, and by
// computing a slice of it; how long it takes to trace, slice and compile; and how much of the trace a slice
// is. Prints a table in Markdown.
//
//   sampling_figures [SECONDS]
//   sampling_figures SECONDS MODEL SEED [interpreted]
//   sampling_figures costs MODEL
//
// The second prints how many Metropolis steps compiled slices, or interpreted ones, make in a second, as the
// programs by hand of bench/sampling/twins/ make them: of a choice that is picked, from its distribution or
// close by. Steps that would leave the path are refused. The third prints what it costs to begin, in runs of
// the program: to trace and slice, and the same with the forms along all choices and what draws by them need;
// and how many microseconds it takes to compile an operation.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/programs.h"
#include "engines/sample/acceptance.h"
#include "engines/sample/shred/traced_structure.h"
#include "engines/sample/state_choices.h"

namespace {

using namespace solitaire;

constexpr const char* kModels[] = {"ising", "regression", "rats",      "mixture",        "infinite_mixture",
                                   "lda",   "hdp",        "citations", "sum_or_product", "polynomial"};
constexpr std::size_t kProposals = 1000;

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// How often `step` can be called in a second, with one number after the other. The clock, to look at which
/// takes as long as many steps, is looked at about every millisecond.
template <class Step>
double rate(double time, Step step) {
  constexpr double kBetweenLooks = 1e-3;
  std::size_t steps = 0, next = 1;
  const double start = seconds();
  double now = start;
  do {
    const double before = now;
    for (std::size_t i = 0; i < next; ++i) step(steps++ % kProposals);
    now = seconds();
    if (now - before < kBetweenLooks) next *= 2;
  } while (now - start < time);
  return static_cast<double>(steps) / (now - start);
}

Program load_model(const std::string& model) {
  const bool is_example = std::filesystem::exists(kSourceFolder / "examples" / "sampling" / (model + ".sol"));
  return load_example((is_example ? "sampling/" : "../bench/sampling/layouts/") + model + ".sol");
}

/// A model at the state from which a chain begins.
struct Started {
  Started(const std::string& model, std::uint64_t seed)
      : program(load_model(model)), stream(seed, Purpose::kSample, 1), rerun(program, params, {}, stream) {
    state = rerun.start();
    rerun.stand_at(state);
    for (const MetChoice& choice : state.choices) values.push_back(choice.value.scalar());
  }
  TracedStructure traced() {
    return trace_structure(program, params, state, rerun.addresses(), {}, ReturnedNumbers(program));
  }
  /// The slices alone, without forms and what draws by them need.
  std::vector<Slice> slices() {
    Graph graph;
    StateChoices choices(state);
    const TracedExecution traced = trace_execution(program, params, choices, graph, rerun.addresses(), {});
    std::vector<NodeId> path;
    for (const PathCondition& condition : traced.path) path.push_back(condition.holds);
    return slices_of(score_program(graph, traced.trace, path, {}, Forms::kLeftOut));
  }

  const Program program;
  const ParamValues params;
  RandomStream stream;
  Rerun rerun;
  SampledState state;
  std::vector<Scalar> values;  // of the choices
};

struct Prepared {
  ChoiceNumber choice;
  Proposal proposal;
};

/// Proposals that change one choice each, of those that can change.
std::vector<Prepared> proposals(const Kernel& kernel, const SampledState& state, RandomStream& stream) {
  Proposer proposer(stream);
  std::vector<Prepared> made;
  while (made.size() < kProposals) {
    const ChoiceNumber choice = stream.below(state.choices.size());
    if (kernel.program().choices[choice].cell == kNoCell) continue;
    const MetChoice& at = state.choices[choice];
    Proposal proposal = proposer.propose(at.address, at.domain, at.value);
    if (at.domain.contains(proposal.value)) made.push_back({choice, proposal});
  }
  return made;
}

double mean_slice(const Kernel& kernel, const std::vector<Prepared>& made) {
  double sum = 0;
  for (const Prepared& each : made) sum += static_cast<double>(kernel.slice(each.choice).changes.size() - 1);
  return sum / static_cast<double>(made.size());
}

void compile_slices(const Kernel& kernel) {
  const ScoreProgram& program = kernel.program();
  const auto shared_end = static_cast<Cell>(program.cells.size());
  Compiler compiler;
  for (ChoiceNumber i = 0; i < program.choices.size(); ++i)
    compiler.compile(kernel.slice(i).code, shared_end);
}

void measure(const std::string& model, double time) {
  Started started(model, 1);
  const double before = seconds();
  TracedStructure structure = started.traced();
  const double traced = seconds() - before;
  structure.load(started.state);
  Kernel interpreted(structure.kernel.program(), false);
  std::vector<Scalar> values = started.values;
  interpreted.load(values);
  const std::vector<Prepared> made = proposals(interpreted, started.state, started.stream);

  SampledState proposed;
  const double by_running =
      rate(time, [&](std::size_t i) { started.rerun.propose(made[i].choice, made[i].proposal, proposed); });
  const double by_trace = rate(time, [&](std::size_t i) {
    const Scalar kept = values[made[i].choice];
    values[made[i].choice] = made[i].proposal.value.scalar();
    interpreted.load(values);
    values[made[i].choice] = kept;
  });
  interpreted.load(values);
  const auto by_slice = [&](Kernel& kernel) {
    return rate(time,
                [&](std::size_t i) { kernel.propose(made[i].choice, made[i].proposal.value.scalar()); });
  };
  const double by_machine = by_slice(interpreted);
  by_slice(structure.kernel);  // until all slices are compiled
  const double by_code = by_slice(structure.kernel);
  const double before_code = seconds();
  compile_slices(interpreted);
  const double compiled = seconds() - before_code;
  const double statements = static_cast<double>(interpreted.program().code.size());
  const double slice = mean_slice(interpreted, made);
  std::printf("| %s | %.0f | %.1f | %.0f | %.1f | %.1f | %.0f | %.1f | %.1f | %.2f | %.2f |\n", model.c_str(),
              statements, slice, by_running, by_trace / by_running, by_machine / by_trace, by_code,
              by_code / by_machine, by_code / by_running / 1000, 1000 * traced, 1000 * compiled);
  std::fflush(stdout);
}

/// How many steps a Metropolis chain on one path makes in a second.
double metropolis_rate(const std::string& model, double time, std::uint64_t seed, bool compiled) {
  Started started(model, seed);
  Kernel kernel(started.traced().kernel.program(), compiled);
  kernel.load(started.values);
  RandomStream& stream = started.stream;
  Proposer proposer(stream);
  const auto step = [&](std::size_t) {
    const ChoiceNumber choice = stream.pick(static_cast<std::uint32_t>(kernel.program().choices.size()));
    if (kernel.program().choices[choice].cell == kNoCell) return;
    const Distribution& distribution = kernel.domain(choice);
    const TypedScalar present(distribution.type(), kernel.value(choice));
    const Proposal proposal =
        proposer.propose(kernel.program().choices[choice].address, distribution, present);
    const double uniform = stream.uniform();
    const bool possible = distribution.contains(proposal.value) &&
                          kernel.propose(choice, proposal.value.scalar()) == Kernel::Outcome::kScored;
    if (possible && accepts(kernel.difference() + proposal.log_ratio, uniform)) kernel.accept();
  };
  rate(time / 4, step);  // until all slices are compiled
  return rate(time, step);
}

/// The least seconds of some times that `work` is done.
template <class Work>
double least_seconds(Work work) {
  double least = HUGE_VAL;
  for (int i = 0; i < 5; ++i) {
    const double before = seconds();
    work();
    least = std::min(least, seconds() - before);
  }
  return least;
}

void print_costs(const std::string& model) {
  Started started(model, 1);
  const TracedStructure structure = started.traced();
  const Kernel& kernel = structure.kernel;
  std::size_t operations = 0;
  for (ChoiceNumber i = 0; i < started.state.choices.size(); ++i) operations += kernel.slice(i).code.size();
  const double compiled = least_seconds([&] { compile_slices(kernel); });
  const std::vector<Prepared> made = proposals(kernel, started.state, started.stream);
  SampledState proposed;
  const double runs =
      rate(0.2, [&](std::size_t i) { started.rerun.propose(made[i].choice, made[i].proposal, proposed); });
  const double sliced = least_seconds([&] { return started.slices(); });
  const double traced = least_seconds([&] { return started.traced(); });
  std::printf("%.1f %.1f %.3f\n", sliced * runs, traced * runs,
              1e6 * compiled / static_cast<double>(operations));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2 && std::string(argv[1]) == "costs") {
    print_costs(argv[2]);
    return 0;
  }
  const double time = argc > 1 ? std::stod(argv[1]) : 0.2;
  if (argc > 2) {
    std::printf("%.0f\n", metropolis_rate(argv[2], time, argc > 3 ? std::stoull(argv[3]) : 1, argc < 5));
    return 0;
  }
  std::puts(
      "| model | statements of the trace | mean slice | running again, steps/s | trace / running | slice / "
      "trace | "
      "compiled slice, steps/s | compiled / interpreted | thousand times running | tracing and slicing, ms | "
      "compiling all, ms |");
  std::puts("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |");
  for (const char* model : kModels) measure(model, time);
}
