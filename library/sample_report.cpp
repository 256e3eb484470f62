#include "library/sample_report.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "base/counted.h"

namespace solitaire::api {
namespace {

constexpr double kWidth = 320;
constexpr double kHeight = 120;
/// So many points of a line or a cloud are drawn; more would not be seen.
constexpr std::size_t kMostPoints = 400;
constexpr std::size_t kBins = 40;
constexpr std::size_t kRankBins = 20;
/// So many numbers are shown in pairs, and so many at all.
constexpr std::size_t kMostInPairs = 5;
constexpr std::size_t kMostReported = 60;

const char* color_of_chain(std::size_t chain) {
  constexpr const char* kColors[] = {"#3366aa", "#cc6633", "#339966", "#884499", "#aa8822", "#777777"};
  return kColors[chain % std::size(kColors)];
}

std::string html_text(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '<') {
      escaped += "&lt;";
    } else if (c == '>') {
      escaped += "&gt;";
    } else if (c == '&') {
      escaped += "&amp;";
    } else if (c == '"') {
      escaped += "&quot;";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

struct Extent {
  double low = HUGE_VAL, high = -HUGE_VAL;

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  /// Where the value lies, from 0 to 1; the middle if all are alike.
  double place(double value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

Extent extent_of(const ChainDraws& draws) {
  Extent extent;
  for (const auto& chain : draws)
    for (const double value : chain) extent.add(value);
  return extent;
}

double across(double share) { return 4 + share * (kWidth - 8); }
double upwards(double share) { return kHeight - 4 - share * (kHeight - 8); }

std::string picture(const std::string& inside, const std::string& caption) {
  return fmt::format(
      "<figure><svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">{}</svg><figcaption>{}</figcaption>"
      "</figure>\n",
      kWidth, kHeight, html_text(caption), inside, html_text(caption));
}

std::string line(const std::vector<std::pair<double, double>>& points, std::size_t chain) {
  std::string text = fmt::format("<polyline fill=\"none\" stroke=\"{}\" stroke-width=\"1\" points=\"",
                                 color_of_chain(chain));
  for (const auto& [x, y] : points) text += fmt::format("{:.1f},{:.1f} ", across(x), upwards(y));
  return text + "\"/>";
}

std::string trace_picture(const ReportedNumber& number) {
  const Extent extent = extent_of(number.draws);
  std::string lines;
  for (std::size_t c = 0; c < number.draws.size(); ++c) {
    const auto& chain = number.draws[c];
    const std::size_t step = std::max<std::size_t>(1, chain.size() / kMostPoints);
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < chain.size(); i += step)
      points.emplace_back(static_cast<double>(i) / static_cast<double>(chain.size()), extent.place(chain[i]));
    lines += line(points, c);
  }
  return picture(lines, fmt::format("draws in their order, from {:.4g} to {:.4g}", extent.low, extent.high));
}

/// Lines over equally wide bins: how many values lie in each, of the most that lie in one.
std::string bin_picture(const ChainDraws& places, std::size_t bins, const std::string& caption) {
  std::vector<std::vector<double>> counts(places.size(), std::vector<double>(bins, 0));
  double most = 1;
  for (std::size_t c = 0; c < places.size(); ++c) {
    for (const double place : places[c]) {
      const auto bin = std::min(bins - 1, static_cast<std::size_t>(place * static_cast<double>(bins)));
      most = std::max(most, ++counts[c][bin]);
    }
  }
  std::string lines;
  for (std::size_t c = 0; c < places.size(); ++c) {
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < bins; ++i) {
      const double height = counts[c][i] / most;
      points.emplace_back(static_cast<double>(i) / static_cast<double>(bins), height);
      points.emplace_back(static_cast<double>(i + 1) / static_cast<double>(bins), height);
    }
    lines += line(points, c);
  }
  return picture(lines, caption);
}

std::string density_picture(const ReportedNumber& number) {
  const Extent extent = extent_of(number.draws);
  ChainDraws places = number.draws;
  for (auto& chain : places)
    for (double& value : chain) value = extent.place(value);
  return bin_picture(places, kBins, "how often values occur, by chain");
}

/// Each draw's rank among the draws of all chains. Chains that agree have as many of each rank.
std::string rank_picture(const ReportedNumber& number) {
  std::vector<double> all;
  for (const auto& chain : number.draws) all.insert(all.end(), chain.begin(), chain.end());
  std::sort(all.begin(), all.end());
  ChainDraws places = number.draws;
  for (auto& chain : places) {
    for (double& value : chain) {
      const auto [low, high] = std::equal_range(all.begin(), all.end(), value);
      const double rank = 0.5 * static_cast<double>((low - all.begin()) + (high - all.begin()));
      value = rank / static_cast<double>(all.size());
    }
  }
  return bin_picture(places, kRankBins, "ranks by chain: level lines agree");
}

std::string pair_picture(const ReportedNumber& a, const ReportedNumber& b) {
  const Extent x = extent_of(a.draws), y = extent_of(b.draws);
  std::string points;
  for (std::size_t c = 0; c < a.draws.size(); ++c) {
    const std::size_t step = std::max<std::size_t>(1, a.draws[c].size() / kMostPoints);
    for (std::size_t i = 0; i < a.draws[c].size(); i += step) {
      points +=
          fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"1.2\" fill=\"{}\" fill-opacity=\"0.5\"/>",
                      across(x.place(a.draws[c][i])), upwards(y.place(b.draws[c][i])), color_of_chain(c));
    }
  }
  return picture(points, fmt::format("{} (across) and {} (upwards)", a.summary.name, b.summary.name));
}

/// What stands before the numbers: the colours are those of the page of solutions, and follow the reader's
/// system.
constexpr const char* kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{0}</title>
<style>
:root {{ color-scheme: light dark; --page: #f4f3f0; --card: #fff; --paper: #f6f6f4; --ink: #1d2126; --soft: #565d67; --line: #dcd9d2; }}
@media (prefers-color-scheme: dark) {{
  :root {{ --page: #16181b; --card: #202327; --paper: #2a2e34; --ink: #e9eaec; --soft: #a9b0ba; --line: #3a3f46; }}
}}
* {{ box-sizing: border-box; }}
body {{ margin: 0; background: var(--page); color: var(--ink); font: 1rem/1.45 system-ui, sans-serif; }}
main {{ max-width: 80rem; margin: auto; padding: 1.5rem clamp(.8rem, 3vw, 2.5rem); }}
h1, h2 {{ overflow-wrap: anywhere; }}
h2 {{ margin: 1.6rem 0 .5rem; font-size: 1.1rem; }}
pre {{ overflow-x: auto; padding: .8rem; background: var(--card); border: 1px solid var(--line); border-radius: .5rem; font-size: .85rem; }}
figure {{ display: inline-block; width: min(22rem, 100%); margin: 0 .8rem .8rem 0; padding: .6rem; background: var(--card); border: 1px solid var(--line); border-radius: .5rem; vertical-align: top; }}
svg {{ display: block; width: 100%; background: var(--paper); }}
figcaption {{ margin-top: .4rem; color: var(--soft); font-size: .8rem; }}
</style>
</head>
<body>
<main>
<h1>{0}</h1>
)";

std::string summary_table(const SampleSummary& summary) {
  std::string text = "<pre tabindex=\"0\" role=\"region\" aria-label=\"Summary\">" +
                     html_text(to_text(summary)) + "</pre>\n";
  return text + fmt::format("<p>{} of {}; {} steps, {:.0f} % of them taken.</p>\n",
                            counted(summary.draws, "draw"), counted(summary.chains, "chain"), summary.steps,
                            100 * summary.acceptance);
}

}  // namespace

std::string report_page(const std::string& title, const SampleSummary& summary,
                        const std::vector<ReportedNumber>& numbers) {
  std::string page = fmt::format(kHead, html_text(title));
  page += summary_table(summary);
  const std::size_t shown = std::min(numbers.size(), kMostReported);
  for (std::size_t i = 0; i < shown; ++i) {
    page += fmt::format("<h2>{}</h2>\n", html_text(numbers[i].summary.name));
    page += trace_picture(numbers[i]) + density_picture(numbers[i]) + rank_picture(numbers[i]);
  }
  if (shown < numbers.size())
    page += fmt::format("<p>The other {} numbers are in the table alone.</p>\n", numbers.size() - shown);
  if (numbers.size() > 1) page += "<h2>Pairs</h2>\n";
  const std::size_t paired = std::min(numbers.size(), kMostInPairs);
  for (std::size_t i = 0; i < paired; ++i)
    for (std::size_t j = i + 1; j < paired; ++j) page += pair_picture(numbers[i], numbers[j]);
  return page + "</main>\n</body>\n</html>\n";
}

}  // namespace solitaire::api
