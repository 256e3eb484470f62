#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <optional>

#include "app/commands.h"
#include "app/console.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/session.h"
#include "base/counted.h"

namespace solitaire::app {
namespace {

SampleOptions sampling(const Session& session, const Options& options) {
  SampleOptions sample = options.sampling;
  static_cast<solitaire::api::Options&>(sample) = session.search;
  return sample;
}

std::string account(const SampleSummary& summary) {
  std::string text = fmt::format("{} of {} in {:.1f} s, {:.0f} steps a second, {:.0f} % accepted",
                                 counted(summary.draws, "draw"), counted(summary.chains, "chain"),
                                 summary.seconds, summary.steps_per_second, 100 * summary.acceptance);
  for (const SampledMoves& move : summary.moves) {
    text +=
        fmt::format("\n  {}: {:.0f} % of {} accepted", move.name,
                    100.0 * static_cast<double>(move.accepted) / static_cast<double>(move.tried), move.tried);
  }
  return text + "\n";
}

}  // namespace

/// Draws executions by how probable they are, and sums up what the program returns. A limit ends the drawing
/// in good order: what is drawn by then is summed up and kept.
ExitStatus sample_command(const Options& options, Watchdog& watchdog) {
  const Session session(options);
  const SampleOptions asked = sampling(session, options);
  Progress progress(!options.quiet);
  Sampler sampler(session.program, asked);
  // Chains look at the limit after each step, so the watchdog, which would lose their draws, looks at none.
  const Watchdog::AtLimit at_limit(
      watchdog, [&] { return report_limit(options); }, StopToken());
  std::optional<DrawPrinter> printer;
  std::function<void(const SampledDraw&)> kept;
  if (options.stream) {
    printer.emplace(*options.stream);
    kept = [&](const SampledDraw& draw) { printer->print(draw); };
  }
  const SampleSummary summary = sampler.run(
      [&](std::uint64_t done, std::uint64_t all) {
        if (done % 64 == 0) progress.update(fmt::format("{} of {} draws", done, all));
      },
      kept);
  const auto lock = watchdog.delivering();
  progress.end();
  const std::string text = options.json ? to_json(summary) + "\n" : to_text(summary);
  if (!printer) {
    print_result(text);
  } else if (!options.quiet) {
    tell(text);
  }
  if (printer && !printer->left_out().empty()) {
    tell(fmt::format(
        "warning: not all draws have the same numbers; the table lacks {} (--stream jsonl has all)\n",
        fmt::join(printer->left_out(), ", ")));
  }
  if (!options.quiet) tell(account(summary));
  // Last, for a file that cannot be written must not take the summary with it.
  if (options.draws_file) sampler.write_draws(*options.draws_file);
  if (options.report_file) sampler.write_report(*options.report_file, summary);
  if (!asked.stop.stopped()) return watchdog.conclude(kDelivered);
  if (!options.quiet) tell(limit_text(options) + "\n");
  return watchdog.conclude(kLimit);
}

}  // namespace solitaire::app
