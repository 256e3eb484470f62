#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <solitaire/sample.h>

#include "base/counted.h"
#include "engines/sample/diagnostics/draw_summary.h"
#include "engines/sample/sampling.h"
#include "engines/tuning.h"
#include "library/draw_order.h"
#include "library/program_state.h"
#include "library/sample_report.h"
#include "library/stop_access.h"
#include "library/translate.h"
#include "scene/atomic_file.h"

namespace solitaire::api {
namespace {

SamplingOptions sampling_of(const SampleOptions& options) {
  SamplingOptions sampling;
  if (options.engine == SampleOptions::Engine::kLightweight)
    sampling.engine = SamplingOptions::Engine::kLightweight;
  sampling.seed = options.seed;
  sampling.draws = (options.draws + options.chains - 1) / options.chains;
  sampling.warmup = options.warmup.value_or(std::clamp<std::uint64_t>(sampling.draws, 500, 5000));
  sampling.thin = options.thin;
  sampling.limits.max_steps = options.max_steps;
  sampling.limits.max_depth = options.max_depth;
  sampling.limits.stop = StopAccess::signal(options.stop);
  return sampling;
}

/// The chains that have enough draws to be compared: where a stop came, some may hardly have begun.
std::vector<const DrawTable*> comparable(const std::vector<ChainResult>& chains) {
  std::size_t longest = 0;
  for (const ChainResult& chain : chains) longest = std::max(longest, chain.draws.rows());
  std::vector<const DrawTable*> tables;
  for (const ChainResult& chain : chains)
    if (longest > 0 && 2 * chain.draws.rows() >= longest) tables.push_back(&chain.draws);
  return tables;
}

std::vector<std::string> names_of(const std::vector<const DrawTable*>& tables) {
  std::vector<std::string> names;
  for (const DrawTable* table : tables) {
    for (const std::string& name : table->names())
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

/// The draws of a number, as many of each chain; empty if some draws do not have it.
ChainDraws draws_of(const std::string& name, const std::vector<const DrawTable*>& tables) {
  std::size_t shortest = SIZE_MAX;
  for (const DrawTable* table : tables) shortest = std::min(shortest, table->rows());
  ChainDraws draws;
  for (const DrawTable* table : tables) {
    draws.push_back(table->column(name));
    draws.back().resize(shortest);
    const auto absent = [](double each) { return std::isnan(each); };
    if (std::any_of(draws.back().begin(), draws.back().end(), absent)) return {};
  }
  return draws;
}

SampledNumber summarized(const std::string& name, const ChainDraws& draws) {
  const DrawSummary found = summarize(draws);
  return {name,      found.mean, found.sd,       found.mcse,     found.q5,
          found.q50, found.q95,  found.ess_bulk, found.ess_tail, found.rhat};
}

/// What chains came across that makes draws doubtful.
void warn_of_troubles(const std::vector<ChainResult>& chains, std::uint64_t sweeps, SampleSummary& summary) {
  Troubles all;
  for (const ChainResult& chain : chains) {
    all.divergences += chain.troubles.divergences;
    all.unbounded += chain.troubles.unbounded;
    all.infinities += chain.troubles.infinities;
  }
  const auto warn = [&](const std::string& text) { summary.warnings.push_back(text); };
  if (2 * all.unbounded > sweeps) {
    warn(
        "the density has no end along some choice, all others being what they are, so it is that of no "
        "distribution; a factor may grow faster than the choice's own distribution falls");
  }
  if (all.infinities > 0) {
    warn(fmt::format(
        "the density is infinite where {} led, and nothing went there; keep factors finite, and scales and "
        "arguments of log away from 0",
        counted(all.infinities, "step")));
  }
  if (all.divergences > 0) {
    warn(fmt::format(
        "the No-U-Turn sampler diverged along {}: somewhere the density bends too sharply for its "
        "steps, and draws from there may be missing; draw normal(0, 1) and multiply it by its scale rather "
        "than normal(0, scale), or ask for a longer warm-up (--warmup)",
        all.divergences == 1 ? "a trajectory" : fmt::format("{} trajectories", all.divergences)));
  }
}

void add_moves(const std::vector<ChainResult>& chains, SampleSummary& summary) {
  MoveCounts all;
  for (const ChainResult& chain : chains) {
    for (const auto& [name, count] : chain.moves) {
      all[name].tried += count.tried;
      all[name].accepted += count.accepted;
    }
  }
  std::uint64_t accepted = 0;
  for (const auto& [name, count] : all) {
    summary.moves.push_back({name, count.tried, count.accepted});
    summary.steps += count.tried;
    accepted += count.accepted;
  }
  if (summary.steps > 0)
    summary.acceptance = static_cast<double>(accepted) / static_cast<double>(summary.steps);
}

/// "a, b and 3 more"
std::string listed(const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kShown); ++i) text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > kShown ? fmt::format("{} and {} more", text, names.size() - kShown) : text;
}

template <class Condition>
std::string where(const SampleSummary& summary, Condition holds) {
  std::vector<std::string> names;
  for (const SampledNumber& number : summary.parameters)
    if (holds(number)) names.push_back(number.name);
  return listed(names);
}

void add_warnings(SampleSummary& summary, const std::vector<std::string>& partial, bool stopped) {
  const auto warn = [&](const std::string& text) { summary.warnings.push_back(text); };
  if (stopped) warn("stopped before all draws were there; the summary is of those that were");
  const std::string apart = where(summary, [](const auto& each) { return each.rhat > tuning::kMostRHat; });
  if (!apart.empty()) {
    warn(fmt::format(
        "R-hat is above {} for {}: the chains do not agree, so the numbers are not to be trusted; "
        "ask for more draws (-n) or a longer warm-up (--warmup)",
        tuning::kMostRHat, apart));
  }
  const std::string few = where(summary, [](const auto& each) {
    const bool enough = each.ess_bulk >= tuning::kLeastEffective && each.ess_tail >= tuning::kLeastEffective;
    return !enough && each.mcse != 0;  // which it is of a number that never changes
  });
  if (!few.empty()) {
    warn(fmt::format("the draws are worth fewer than {} independent ones for {}: ask for more (-n)",
                     tuning::kLeastEffective, few));
  }
  if (!partial.empty())
    warn(fmt::format("not all draws have {}, so there is no summary of it", listed(partial)));
  if (summary.draws > 0 && summary.steps > 0 && summary.acceptance == 0)
    warn("no step was accepted: every draw of a chain is the one that it started from");
}

}  // namespace

class Sampler::State {
 public:
  State(const Program& program, const SampleOptions& options) : program_(program), options_(options) {
    if (options.draws == 0 || options.chains == 0 || options.thin == 0)
      throw Error(Error::Kind::kUsage, "draws, chains and thin are whole numbers from 1");
  }

  SampleSummary run(const std::function<void(std::uint64_t, std::uint64_t)>& progress,
                    const std::function<void(const SampledDraw&)>& kept) {
    return translated(program_.state().program.sources, [&] {
      const auto start = std::chrono::steady_clock::now();
      draw(progress, kept);
      SampleSummary summary = summary_of_draws();
      summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      if (summary.seconds > 0)
        summary.steps_per_second = static_cast<double>(summary.steps) / summary.seconds;
      return summary;
    });
  }

  void write_draws(const std::filesystem::path& path) const {
    translated(program_.state().program.sources,
               [&] { write_file_atomically(path, draws_text(path.extension() == ".jsonl")); });
  }

  void write_report(const std::filesystem::path& path, const SampleSummary& summary) const {
    translated(program_.state().program.sources, [&] {
      const std::vector<const DrawTable*> tables = comparable(chains_);
      std::vector<ReportedNumber> numbers;
      for (const SampledNumber& each : summary.parameters)
        numbers.push_back({each, draws_of(each.name, tables)});
      write_file_atomically(path, report_page(program_.file_name(), summary, numbers));
    });
  }

 private:
  void draw(const std::function<void(std::uint64_t, std::uint64_t)>& progress,
            const std::function<void(const SampledDraw&)>& kept) {
    const SamplingOptions sampling = sampling_of(options_);
    std::vector<ParamValues> params;  // of each chain its own
    for (std::uint64_t i = 0; i < options_.chains; ++i)
      params.push_back(values_of_params(program_.state(), program_.settings()));
    std::vector<ChainProgram> programs;
    for (const ParamValues& own : params) programs.push_back({&program_.state().program, &own});
    const std::uint64_t all = options_.chains * (sampling.draws + sampling.warmup);
    std::atomic<std::uint64_t> done = 0;
    DrawListener listener{[&] {
      const std::uint64_t now = ++done;
      if (progress) progress(now, all);
    }};
    DrawOrder order(options_.chains, kept);
    if (kept) {
      listener.kept = [&](std::size_t chain, const auto& names, const auto& numbers) {
        order.add(chain, names, numbers);
      };
      listener.ended = [&](std::size_t chain) { order.end(chain); };
    }
    chains_ = run_chains(programs, sampling, options_.jobs, listener);
  }

  SampleSummary summary_of_draws() const {
    SampleSummary summary;
    bool stopped = false;
    for (const ChainResult& chain : chains_) {
      summary.draws += chain.draws.rows();
      stopped = stopped || chain.stopped;
    }
    const std::vector<const DrawTable*> tables = comparable(chains_);
    summary.chains = tables.size();
    std::vector<std::string> partial;
    for (const std::string& name : names_of(tables)) {
      const ChainDraws draws = draws_of(name, tables);
      if (draws.empty()) {
        partial.push_back(name);
      } else {
        summary.parameters.push_back(summarized(name, draws));
      }
    }
    add_moves(chains_, summary);
    add_slowness(summary);
    add_warnings(summary, partial, stopped);
    warn_of_troubles(chains_, options_.thin * summary.draws, summary);
    return summary;
  }

  void add_slowness(SampleSummary& summary) const {
    for (const ChainResult& chain : chains_) {
      if (!chain.slowed_by) continue;
      summary.warnings.push_back(fmt::format(
          "each step runs the program again, which is slow, since at {}: {}",
          program_.state().program.sources.place(chain.slowed_by->span), chain.slowed_by->message));
      return;
    }
  }

  /// Calls with each draw, in the order of chains and of draws, each with all the names that there are.
  template <class Call>
  void each_draw(const std::vector<std::string>& names, Call call) const {
    SampledDraw draw;
    draw.names = names;
    draw.numbers.resize(names.size());
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      std::vector<std::vector<double>> columns;
      for (const std::string& name : names) columns.push_back(chains_[c].draws.column(name));
      for (std::size_t row = 0; row < chains_[c].draws.rows(); ++row) {
        draw.chain = c + 1;
        draw.draw = row + 1;
        for (std::size_t i = 0; i < names.size(); ++i) draw.numbers[i] = columns[i][row];
        call(draw);
      }
    }
  }

  std::string draws_text(bool as_lines) const {
    std::vector<const DrawTable*> tables;
    for (const ChainResult& chain : chains_) tables.push_back(&chain.draws);
    const std::vector<std::string> names = names_of(tables);
    std::string text = as_lines ? "" : csv_names(names) + "\n";
    each_draw(names,
              [&](const SampledDraw& draw) { text += (as_lines ? to_json(draw) : to_csv(draw)) + "\n"; });
    return text;
  }

  Program program_;
  SampleOptions options_;
  std::vector<ChainResult> chains_;
};

Sampler::Sampler(const Program& program, const SampleOptions& options)
    : state_(std::make_unique<State>(program, options)) {}
Sampler::~Sampler() = default;
SampleSummary Sampler::run(const std::function<void(std::uint64_t, std::uint64_t)>& progress,
                           const std::function<void(const SampledDraw&)>& kept) {
  return state_->run(progress, kept);
}
void Sampler::write_report(const std::filesystem::path& path, const SampleSummary& summary) const {
  state_->write_report(path, summary);
}
void Sampler::write_draws(const std::filesystem::path& path) const { state_->write_draws(path); }

}  // namespace solitaire::api
