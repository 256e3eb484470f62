#include "base/diagnostic.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

namespace solitaire {
namespace {

constexpr std::size_t kMostDiagnostics = 20;
constexpr std::size_t kWidestLine = 160;

/// The source line with tabs as single spaces, so that the caret stands below what it means.
std::string shown_line(std::string_view line) {
  std::string shown(line.substr(0, kWidestLine));
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return shown;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> previous(b.size() + 1);
  std::iota(previous.begin(), previous.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::vector<std::size_t> row{i + 1};
    for (std::size_t j = 0; j < b.size(); ++j) {
      row.push_back(std::min({previous[j + 1] + 1, row[j] + 1, previous[j] + (a[i] == b[j] ? 0U : 1U)}));
    }
    previous = std::move(row);
  }
  return previous.back();
}

bool same_letters(std::string a, std::string b) {
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

}  // namespace

std::string format(const Diagnostic& diagnostic, const SourceSet& sources, const std::string& severity) {
  const Span span = diagnostic.span;
  const Source& source = sources[span.source];
  const Position at = source.position(span.begin);
  const std::string_view line = source.line(at.line);
  const std::string number = std::to_string(at.line);

  std::string text =
      fmt::format("{}:{}:{}: {}: {}\n", source.name(), at.line, at.column, severity, diagnostic.message);
  if (at.column <= kWidestLine) {
    const std::size_t left = count_characters(line) + 1 - std::min(count_characters(line) + 1, at.column);
    const std::size_t wanted = count_characters(sources.text(span));
    const std::size_t carets =
        std::max<std::size_t>(1, std::min({wanted, left, kWidestLine - at.column + 1}));
    text += fmt::format("  {} | {}\n", number, shown_line(line));
    text +=
        fmt::format("  {:{}} | {:{}}{}\n", "", number.size(), "", at.column - 1, std::string(carets, '^'));
  }
  for (const std::string& note : diagnostic.notes) text += fmt::format("  note: {}\n", note);
  if (!diagnostic.help.empty()) text += fmt::format("  help: {}\n", diagnostic.help);
  return text;
}

ProgramError::ProgramError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(diagnostics.front().message), diagnostics_(std::move(diagnostics)) {}

void Diagnostics::add(Span span, std::string message, std::string help) {
  if (list_.size() >= kMostDiagnostics) return;
  list_.push_back({span, std::move(message), std::move(help), {}});
}

void Diagnostics::raise_if_any() const {
  if (list_.empty()) return;
  std::vector<Diagnostic> sorted = list_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Diagnostic& a, const Diagnostic& b) {
    return std::pair(a.span.source, a.span.begin) < std::pair(b.span.source, b.span.begin);
  });
  throw ProgramError(std::move(sorted));
}

std::string nearest_name(std::string_view name, const std::vector<std::string>& candidates) {
  std::string best;
  std::size_t best_distance = name.size() <= 3 ? 2 : 3;  // only what is nearer than this
  for (const std::string& candidate : candidates) {
    std::size_t distance = edit_distance(name, candidate);
    if (distance == 2 && same_letters(std::string(name), candidate)) distance = 1;  // two letters swapped
    if (distance < best_distance && distance < candidate.size()) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best;
}

std::vector<std::string> nearest_names(std::string_view name, std::vector<std::string> candidates,
                                       std::size_t count) {
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (std::string& candidate : candidates) {
    const std::size_t distance = edit_distance(std::string(name), candidate);
    ranked.emplace_back(distance, std::move(candidate));
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<std::string> nearest;
  for (std::size_t i = 0; i < std::min(count, ranked.size()); ++i) nearest.push_back(ranked[i].second);
  return nearest;
}

}  // namespace solitaire
