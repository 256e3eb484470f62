#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <solitaire/sample.h>

#include "library/json.h"

namespace solitaire::api {
namespace {

/// Four significant digits, or more of large numbers.
std::string number(double value) {
  if (std::isnan(value)) return "-";
  if (std::abs(value) >= 1000 && std::abs(value) < 1e9) return fmt::format("{:.0f}", value);
  return fmt::format("{:.4g}", value);
}

std::string count(double value) { return std::isnan(value) ? "-" : fmt::format("{:.0f}", value); }
std::string ratio(double value) { return std::isnan(value) ? "-" : fmt::format("{:.3f}", value); }

using Row = std::vector<std::string>;

Row row_of(const SampledNumber& each) {
  return {each.name,        number(each.mean), number(each.sd),      number(each.mcse),    number(each.q5),
          number(each.q50), number(each.q95),  count(each.ess_bulk), count(each.ess_tail), ratio(each.rhat)};
}

std::string table(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths(rows[0].size());
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const Row& row : rows) {
    text += fmt::format("{:<{}}", row[0], widths[0]);
    for (std::size_t i = 1; i < row.size(); ++i) text += fmt::format("  {:>{}}", row[i], widths[i]);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string to_text(const SampleSummary& summary) {
  std::vector<Row> rows = {
      {"", "mean", "sd", "mcse", "5 %", "median", "95 %", "ess bulk", "ess tail", "R-hat"}};
  for (const SampledNumber& each : summary.parameters) rows.push_back(row_of(each));
  std::string text = table(rows);
  if (summary.draws == 0) {
    text = "no draws are there yet\n";
  } else if (summary.parameters.empty()) {
    text = "the program returns no numbers: return numbers or bools, such as x or x == \"oak\"\n";
  }
  for (const std::string& warning : summary.warnings) text += fmt::format("warning: {}\n", warning);
  return text;
}

namespace {

std::string quoted(const std::string& name) {
  if (name.find_first_of(",\"\n") == std::string::npos) return name;
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

}  // namespace

std::string csv_names(const std::vector<std::string>& names) {
  std::string text = "chain,draw";
  for (const std::string& name : names) text += "," + quoted(name);
  return text;
}

std::string to_csv(const SampledDraw& draw) {
  std::string text = fmt::format("{},{}", draw.chain, draw.draw);
  for (const double each : draw.numbers)
    text += std::isnan(each) ? std::string(",") : fmt::format(",{}", each);
  return text;
}

std::string to_json(const SampledDraw& draw) {
  Json values = Json::object();
  for (std::size_t i = 0; i < draw.names.size(); ++i)
    if (!std::isnan(draw.numbers[i])) values[draw.names[i]] = draw.numbers[i];
  return json_text({{"chain", draw.chain}, {"draw", draw.draw}, {"values", values}});
}

std::string to_json(const SampleSummary& summary) {
  Json parameters = Json::array();
  for (const SampledNumber& each : summary.parameters) {
    parameters.push_back({{"name", each.name},
                          {"mean", each.mean},
                          {"sd", each.sd},
                          {"mcse", each.mcse},
                          {"q5", each.q5},
                          {"q50", each.q50},
                          {"q95", each.q95},
                          {"ess_bulk", each.ess_bulk},
                          {"ess_tail", each.ess_tail},
                          {"rhat", each.rhat}});
  }
  Json moves = Json::array();
  for (const SampledMoves& each : summary.moves)
    moves.push_back({{"move", each.name}, {"tried", each.tried}, {"accepted", each.accepted}});
  return json_text({{"parameters", parameters},
                    {"chains", summary.chains},
                    {"draws", summary.draws},
                    {"steps", summary.steps},
                    {"steps_per_second", summary.steps_per_second},
                    {"acceptance", summary.acceptance},
                    {"moves", moves},
                    {"warnings", summary.warnings}});
}

}  // namespace solitaire::api
