#include <cmath>
#include <fmt/format.h>

#include "app/commands.h"
#include "app/console.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/session.h"
#include "app/signals.h"

namespace solitaire {
namespace {

/// As "1.3e9", also where no double is so large.
std::string scientific(double log10) {
  double exponent = std::floor(log10);
  double mantissa = std::round(std::pow(10, log10 - exponent) * 10) / 10;
  if (mantissa >= 10) {
    mantissa /= 10;
    exponent += 1;
  }
  return fmt::format("{:.1f}e{:.0f}", mantissa, exponent);
}

std::string as_text(const SolutionCount& count, const Accuracy& accuracy) {
  if (!count.estimate) {
    const std::string digits = count.digits();
    return fmt::format("{} solution{}\n", digits, digits == "1" ? "" : "s");
  }
  return fmt::format("about {} solutions (within a factor of {} with a confidence of {} %)\n",
                     scientific(count.log10()), 1 + accuracy.tolerance, 100 * accuracy.confidence);
}

std::string as_json(const SolutionCount& count, const Accuracy& accuracy) {
  if (!count.estimate) return fmt::format("{{\"solutions\":{},\"exact\":true}}\n", count.digits());
  return fmt::format("{{\"solutions\":{},\"exact\":false,\"tolerance\":{},\"confidence\":{}}}\n",
                     scientific(count.log10()), accuracy.tolerance, accuracy.confidence);
}

}  // namespace

ExitStatus count(const Options& options, Watchdog& watchdog) {
  const Session session(options);
  Progress progress(!options.quiet);
  SolutionCounter counter(session.program(), session.params(), session.tracing_options(), options.counting);
  const auto end_at_limit = [&] {
    progress.end();
    const std::string least = counter.at_least().digits();
    print_result(options.json ? fmt::format("{{\"at_least\":{},\"exact\":false}}\n", least)
                              : fmt::format("at least {} solution{}\n", least, least == "1" ? "" : "s"));
    if (!options.quiet) tell(limit_text(options) + "\n");
    return kLimit;
  };
  const Watchdog::AtLimit at_limit(watchdog, end_at_limit);
  try {
    const auto counted = counter.run([&](const std::string& what) { progress.update(what); });
    const auto lock = watchdog.delivering();
    progress.end();
    if (!counted) {
      tell(fmt::format("{}: {}\n", options.script, kUnexploredText));
      return watchdog.conclude(kLimit);
    }
    const Accuracy& accuracy = options.counting.accuracy;
    print_result(options.json ? as_json(*counted, accuracy) : as_text(*counted, accuracy));
    return watchdog.conclude(kDelivered);
  } catch (const ProgramError& error) {
    const auto lock = watchdog.delivering();
    progress.end();
    report(error, session.program().sources);
    return watchdog.conclude(kError);
  } catch (const Interrupted&) {
    const auto lock = watchdog.delivering();
    return watchdog.conclude(end_at_limit());
  }
}

}  // namespace solitaire
