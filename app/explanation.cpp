#include "app/explanation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace solitaire {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestQuote = 100;

/// A stretch of the program on one line.
std::string quote(Span span, const SourceSet& sources) {
  std::string words;
  for (const char c : sources.text(span)) {
    const bool space = c == ' ' || c == '\n' || c == '\t' || c == '\r';
    if (!space) {
      words += c;
    } else if (!words.empty() && words.back() != ' ') {
      words += ' ';
    }
  }
  return words.size() > kLongestQuote ? words.substr(0, kLongestQuote) + "..." : words;
}

const char* kind_of(const Condition& condition) {
  if (condition.pin != nullptr) return condition.pin->forbidden ? "forbid" : "pin";
  switch (condition.requirement) {
    case ConstraintKind::kAssert:
      return "assert";
    case ConstraintKind::kLowEnd:
    case ConstraintKind::kHighEnd:
    case ConstraintKind::kStep:
      return "range";
    case ConstraintKind::kNotEmpty:
      return "choice";
    case ConstraintKind::kIndex:
      return "index";
    case ConstraintKind::kDivisor:
      return "divisor";
  }
  return "";
}

std::string value_text(std::int64_t value, Distribution::Family kind) {
  if (kind == Distribution::Family::kFlip) return value != 0 ? "true" : "false";
  return fmt::to_string(value);
}

/// Whether both are ends of the same range, and numbers.
bool same_range(const Condition& a, const Condition& b) {
  return a.pin == nullptr && b.pin == nullptr && a.address == b.address && a.span == b.span &&
         a.requirement == ConstraintKind::kLowEnd && b.requirement == ConstraintKind::kHighEnd && a.domain &&
         b.domain;
}

std::string end_text(const Condition& condition, const std::string& choice) {
  if (condition.requirement == ConstraintKind::kStep) return choice + " is one of the steps of its range";
  const bool low = condition.requirement == ConstraintKind::kLowEnd;
  if (!condition.domain) return fmt::format("{} is not {} its range", choice, low ? "below" : "above");
  return fmt::format("{} is at {} {}", choice, low ? "least" : "most",
                     low ? condition.domain->lo : condition.domain->hi);
}

/// An address says something where a call or a loop turn led there.
bool tells_something(const std::string& address) { return address.find_first_of("/[") != std::string::npos; }

Diagnostic diagnostic_of(const Condition& condition, const std::string& message,
                         const ExplanationContext& context) {
  Diagnostic diagnostic{condition.span, message, "", {}};
  const std::string address = context.addresses.text(condition.address);
  const bool named = message.find(address) != std::string::npos;
  if (!named && tells_something(address)) diagnostic.notes.push_back("at " + address);
  if (!condition.message.empty()) diagnostic.notes.push_back("message: " + condition.message);
  return diagnostic;
}

Json place_json(Span span, const SourceSet& sources) {
  const Source& source = sources[span.source];
  const Position at = source.position(span.begin);
  return {{"file", source.name()}, {"line", at.line}, {"column", at.column}, {"text", quote(span, sources)}};
}

std::string listed(const std::vector<std::int64_t>& values, Distribution::Family kind) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < values.size();) {
    std::size_t last = i;
    while (last + 1 < values.size() && values[last + 1] == values[last] + 1) ++last;
    const std::string first = value_text(values[i], kind);
    parts.push_back(last > i + 1 && kind != Distribution::Family::kFlip
                        ? fmt::format("{}..{}", first, values[last])
                        : first);
    i = last > i + 1 && kind != Distribution::Family::kFlip ? last + 1 : i + 1;
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<std::int64_t> missing_values(const ReachableValues& choice) {
  std::vector<std::int64_t> missing;
  for (std::int64_t value = choice.domain.lo; value <= choice.domain.hi; value += choice.domain.step) {
    if (choice.values.count(value) == 0) missing.push_back(value);
  }
  return missing;
}

}  // namespace

std::string words_of(const Condition& condition, const ExplanationContext& context) {
  const std::string choice = context.addresses.text(condition.address);
  if (condition.pin != nullptr) {
    return fmt::format("{} is {}{}, by {}", choice, condition.pin->forbidden ? "not " : "",
                       value_text(condition.pin->value, condition.domain->family), condition.pin->source);
  }
  switch (condition.requirement) {
    case ConstraintKind::kAssert:
      return quote(condition.span, context.sources);
    case ConstraintKind::kLowEnd:
    case ConstraintKind::kHighEnd:
    case ConstraintKind::kStep:
      return end_text(condition, choice);
    case ConstraintKind::kNotEmpty:
      return "there must be something to choose from";
    case ConstraintKind::kIndex:
      return "the list must have such an element";
    case ConstraintKind::kDivisor:
      return "the divisor must not be zero";
  }
  return "";
}

std::string conflict_text(const Conflict& conflict, const ExplanationContext& context) {
  const std::vector<Condition>& members = conflict.members;
  std::string text;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < members.size(); ++i, ++shown) {
    std::string words = words_of(members[i], context);
    if (i + 1 < members.size() && same_range(members[i], members[i + 1])) {
      words = fmt::format("{} lies within {}..{}", context.addresses.text(members[i].address),
                          members[i].domain->lo, members[i].domain->hi);
      ++i;
    }
    text += format(diagnostic_of(members[i], words, context), context.sources, kind_of(members[i]));
  }
  const std::string head =
      shown == 1 ? "this cannot hold:\n" : fmt::format("these {} cannot hold together:\n", shown);
  if (!conflict.minimal) text += "it was not found out whether all of them are needed, nor which ranges\n";
  return head + text;
}

std::string dead_text(const DeadAsserts& asserts, const SourceSet& sources) {
  std::string text;
  for (const DeadAssert& each : asserts.dead) {
    const std::string why = each.met ? "this rules nothing out: it holds wherever the other conditions do"
                                     : "this rules nothing out: no execution comes to it";
    text += format({each.span, why, "", {}}, sources, "note");
  }
  if (asserts.undecided > 0) {
    text += fmt::format("of {} further assert{} it was not found out whether {} anything out\n",
                        asserts.undecided, asserts.undecided == 1 ? "" : "s",
                        asserts.undecided == 1 ? "it rules" : "they rule");
  }
  return text;
}

std::string values_text(const ReachableValues& choice, const ExplanationContext& context) {
  const std::string address = context.addresses.text(choice.address);
  const Distribution::Family kind = choice.domain.family;
  if (choice.values.empty()) {
    return fmt::format(
        "{}: {}\n", address,
        choice.complete ? "no solution makes this choice" : "not found out, a limit came first");
  }
  const std::vector<std::int64_t> values(choice.values.begin(), choice.values.end());
  std::string text;
  if (choice.listed) {
    const auto missing = missing_values(choice);
    text = fmt::format("{}: {}", address, listed(values, kind));
    if (choice.complete && !missing.empty()) text += fmt::format("; never {}", listed(missing, kind));
  } else {
    text = fmt::format("{}: from {} to {}, of {} to {}", address, values.front(), values.back(),
                       choice.domain.lo, choice.domain.hi);
  }
  if (!choice.complete) text += "; perhaps others, a limit came first";
  return text + "\n";
}

Json conflict_json(const Conflict& conflict, const ExplanationContext& context) {
  Json members = Json::array();
  for (const Condition& condition : conflict.members) {
    Json member{{"kind", kind_of(condition)}};
    member.update(place_json(condition.span, context.sources));
    member["at"] = context.addresses.text(condition.address);
    member["condition"] = words_of(condition, context);
    if (!condition.message.empty()) member["message"] = condition.message;
    if (condition.pin != nullptr) {
      member["pin"] = condition.pin->source;
      member["value"] = condition.pin->value;
    }
    members.push_back(std::move(member));
  }
  return {{"minimal", conflict.minimal}, {"members", members}};
}

Json dead_json(const DeadAsserts& asserts, const SourceSet& sources) {
  Json list = Json::array();
  for (const DeadAssert& each : asserts.dead) {
    Json entry = place_json(each.span, sources);
    entry["met"] = each.met;
    list.push_back(std::move(entry));
  }
  return list;
}

Json values_json(const ReachableValues& choice, const ExplanationContext& context) {
  Json json = {{"at", context.addresses.text(choice.address)},
               {"from", choice.domain.lo},
               {"to", choice.domain.hi},
               {"step", choice.domain.step},
               {"complete", choice.complete}};
  const std::vector<std::int64_t> values(choice.values.begin(), choice.values.end());
  if (choice.listed) {
    json["values"] = values;
    if (choice.complete) json["never"] = missing_values(choice);
  } else if (!values.empty()) {
    json["least"] = values.front();
    json["greatest"] = values.back();
  }
  return json;
}

}  // namespace solitaire
