#pragma once
#include <solitaire/sample.h>
#include <string>
#include <vector>

#include "engines/sample/diagnostics/draw_summary.h"

namespace solitaire::api {

/// A number with its draws.
struct ReportedNumber {
  SampledNumber summary;
  ChainDraws draws;
};

/// Returns a page that shows the summary and, of each number, a trace of its draws, their density and ranks
/// by chain, and draws of pairs of numbers. It stands alone: pictures are SVG within it, and it has no
/// scripts.
std::string report_page(const std::string& title, const SampleSummary& summary,
                        const std::vector<ReportedNumber>& numbers);

}  // namespace solitaire::api
