#include "library/explanation.h"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "base/counted.h"
#include "library/freeze.h"

namespace solitaire::api {
namespace {

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

const char* kind_of(const solitaire::Condition& condition) {
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

std::string value_text(std::int64_t value, bool is_bool) {
  if (is_bool) return value != 0 ? "true" : "false";
  return fmt::to_string(value);
}

/// Returns true if both are ends of the same range, and numbers.
bool same_range(const solitaire::Condition& a, const solitaire::Condition& b) {
  return a.pin == nullptr && b.pin == nullptr && a.address == b.address && a.span == b.span &&
         a.requirement == ConstraintKind::kLowEnd && b.requirement == ConstraintKind::kHighEnd && a.domain &&
         b.domain;
}

std::string end_text(const solitaire::Condition& condition, const std::string& choice) {
  if (condition.requirement == ConstraintKind::kStep) return choice + " is one of the steps of its range";
  const bool low = condition.requirement == ConstraintKind::kLowEnd;
  if (!condition.domain) return fmt::format("{} is not {} its range", choice, low ? "below" : "above");
  return fmt::format("{} is at {} {}", choice, low ? "least" : "most",
                     low ? condition.domain->lo : condition.domain->hi);
}

/// Returns true if a call or a loop turn led to the address; else it says nothing that its place does not
/// say.
bool tells_something(const std::string& address) { return address.find_first_of("/[") != std::string::npos; }

solitaire::Diagnostic diagnostic_of(const solitaire::Condition& condition, const std::string& message,
                                    const ExplanationContext& context) {
  solitaire::Diagnostic diagnostic{condition.span, message, "", {}};
  const std::string address = context.addresses.text(condition.address);
  const bool named = message.find(address) != std::string::npos;
  if (!named && tells_something(address)) diagnostic.notes.push_back("at " + address);
  if (!condition.turn.empty()) diagnostic.notes.push_back("where " + condition.turn);
  if (!condition.message.empty()) diagnostic.notes.push_back("message: " + condition.message);
  if (condition.unlike)
    diagnostic.notes.push_back(
        "whatever is chosen, this fails: values of different kinds, such as an int and a bool, are never "
        "equal");
  return diagnostic;
}

Place place_of(Span span, const SourceSet& sources) {
  const Source& source = sources[span.source];
  const Position at = source.position(span.begin);
  return {source.name(), at.line, at.column, quote(span, sources)};
}

std::string listed_elements(const std::vector<std::int64_t>& values,
                            const std::vector<std::string>& elements) {
  std::vector<std::string> parts;
  for (const std::int64_t value : values) parts.push_back(elements[static_cast<std::size_t>(value)]);
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Returns "false, true", `"oven", "sink"`, or "1..3, 7".
std::string listed(const std::vector<std::int64_t>& values, const ReachableValues& choice) {
  if (!choice.elements.empty()) return listed_elements(values, choice.elements);
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < values.size();) {
    std::size_t last = i;
    while (last + 1 < values.size() && values[last + 1] == values[last] + 1) ++last;
    const bool is_stretch = last > i + 1 && !choice.is_bool;
    const std::string first = value_text(values[i], choice.is_bool);
    parts.push_back(is_stretch ? fmt::format("{}..{}", first, values[last]) : first);
    i = is_stretch ? last + 1 : i + 1;
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::vector<std::int64_t> missing_values(const solitaire::ReachableValues& choice) {
  std::vector<std::int64_t> missing;
  for (std::int64_t value = choice.domain.lo; value <= choice.domain.hi; value += choice.domain.step) {
    if (choice.values.count(value) == 0) missing.push_back(value);
  }
  return missing;
}

}  // namespace

std::string words_of(const solitaire::Condition& condition, const ExplanationContext& context) {
  const std::string choice = context.addresses.text(condition.address);
  if (condition.pin != nullptr) {
    return fmt::format("{} is {}{}, by {}{}", choice, condition.pin->forbidden ? "not " : "",
                       condition.pinned, condition.pin->source,
                       condition.possible.empty() ? "" : fmt::format("; it can be {}", condition.possible));
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

namespace {

/// So few conditions are as plain as the totals of their sums would be.
constexpr std::size_t kMostPlain = 6;

/// Returns "17 things that do not overlap need an area of 68, and lie within one of 64", "added up, these
/// conditions ask for 84 at least, and allow 64 at most", or "" where that is not the reason.
std::string reason_of(const solitaire::Conflict& conflict) {
  if (!conflict.room) return "";
  const OverFull& room = *conflict.room;
  if (room.measure == OverFull::Measure::kArea) {
    return fmt::format("{} things that do not overlap need an area of {}, and lie within one of {}",
                       room.things, room.needed, room.available);
  }
  if (room.measure == OverFull::Measure::kSum) {
    if (conflict.members.size() <= kMostPlain) return "";
    return fmt::format("added up, these conditions ask for {} at least, and allow {} at most", room.needed,
                       room.available);
  }
  if (room.needed == static_cast<std::int64_t>(room.things))
    return fmt::format("{} ints that all differ lie among {} values", room.things, room.available);
  return fmt::format("{} things that do not overlap need a length of {}, and lie within one of {}",
                     room.things, room.needed, room.available);
}

/// Members that are told as one: both ends of a range, or what one place of the text asks of many calls and
/// turns.
struct Told {
  std::string words;
  std::vector<const solitaire::Condition*> members;
};

/// A place that takes part more often than this is told once.
constexpr std::size_t kMostAlike = 3;
/// About a screen: with its line, its carets and its notes each takes four lines.
constexpr std::size_t kMostTold = 9;

/// Returns each member by itself, and both ends of a range as one.
std::vector<Told> each_told(const solitaire::Conflict& conflict, const ExplanationContext& context) {
  const std::vector<solitaire::Condition>& members = conflict.members;
  std::vector<Told> told;
  for (std::size_t i = 0; i < members.size(); ++i) {
    told.push_back({words_of(members[i], context), {&members[i]}});
    if (i + 1 == members.size() || !same_range(members[i], members[i + 1])) continue;
    told.back().words = fmt::format("{} lies within {}..{}", context.addresses.text(members[i].address),
                                    members[i].domain->lo, members[i].domain->hi);
    ++i;
  }
  return told;
}

/// Returns what stands at one place of the text as one, where that is much.
std::vector<Told> alike_as_one(std::vector<Told> told) {
  const auto place = [](const Told& one) {
    const solitaire::Condition& first = *one.members.front();
    return std::tuple(first.span.source, first.span.begin, first.span.end, std::string(kind_of(first)));
  };
  std::map<decltype(place(told.front())), std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < told.size(); ++i) places[place(told[i])].push_back(i);
  std::vector<Told> fewer;
  for (std::size_t i = 0; i < told.size(); ++i) {
    const std::vector<std::size_t>& alike = places[place(told[i])];
    if (alike.size() <= kMostAlike) fewer.push_back(std::move(told[i]));
    if (alike.size() <= kMostAlike || alike.front() != i) continue;
    fewer.push_back({told[i].words, {}});
    for (const std::size_t other : alike) fewer.back().members.push_back(told[other].members.front());
  }
  return fewer;
}

/// Says which of many turns or calls this is: "x = 3, y = 1", or the address.
std::string turn_text(const solitaire::Condition& condition, const ExplanationContext& context) {
  return condition.turn.empty() ? context.addresses.text(condition.address) : condition.turn;
}

/// Says where members that are told as one stand.
std::string times_text(const Told& told, const ExplanationContext& context) {
  constexpr std::size_t kNamed = 3;
  std::vector<std::string> turns;
  for (std::size_t i = 0; i < kNamed; ++i) turns.push_back(turn_text(*told.members[i], context));
  const char* const between = told.members.front()->turn.empty() ? ", " : "; ";
  return fmt::format("{} times, first at {}{}last at {}", told.members.size(), fmt::join(turns, between),
                     between, turn_text(*told.members.back(), context));
}

std::string told_text(const Told& told, const ExplanationContext& context) {
  const solitaire::Condition& first = *told.members.front();
  if (told.members.size() == 1) {
    return format(diagnostic_of(first, told.words, context), context.sources, kind_of(first));
  }
  solitaire::Diagnostic diagnostic{first.span, told.words, "", {times_text(told, context)}};
  if (!first.message.empty()) diagnostic.notes.push_back("message: " + first.message);
  return format(diagnostic, context.sources, kind_of(first));
}

/// Asserts and pins say more than ranges, so that they come first where not all is told.
void keep_a_screen(std::vector<Told>& told) {
  const auto is_range = [](const Told& one) {
    return is_end(one.members.front()->requirement) && one.members.front()->pin == nullptr;
  };
  std::stable_partition(told.begin(), told.end(), [&](const Told& one) { return !is_range(one); });
  told.resize(kMostTold - 1);
}

std::string conflict_text(const solitaire::Conflict& conflict, const ExplanationContext& context,
                          bool whole) {
  std::vector<Told> told = each_told(conflict, context);
  const std::size_t count = told.size();
  if (!whole) told = alike_as_one(std::move(told));
  const std::size_t places = told.size();
  if (!whole && places > kMostTold) keep_a_screen(told);
  std::string text =
      count == 1 ? "this cannot hold:\n" : fmt::format("these {} cannot hold together:\n", count);
  for (const Told& one : told) text += told_text(one, context);
  if (told.size() < places)
    text += fmt::format("and {} others; explain --full shows them all\n", places - told.size());
  if (const std::string reason = reason_of(conflict); !reason.empty())
    text += fmt::format("the reason: {}\n", reason);
  if (!conflict.minimal) text += "it was not found out whether all of them are needed, nor which ranges\n";
  return text;
}

std::string dead_text(const solitaire::DeadAsserts& asserts, const SourceSet& sources) {
  std::string text;
  for (const solitaire::DeadAssert& each : asserts.dead) {
    const std::string why = each.met ? "this rules nothing out: it holds wherever the other conditions do"
                                     : "this rules nothing out: no execution comes to it";
    text += format({each.span, why, "", {}}, sources, "note");
  }
  if (asserts.undecided > 0) {
    text += fmt::format("of {} it was not found out whether {} anything out\n",
                        counted(asserts.undecided, "further assert"),
                        asserts.undecided == 1 ? "it rules" : "they rule");
  }
  return text;
}

std::string values_text(const ReachableValues& choice) {
  if (choice.values.empty()) {
    return fmt::format(
        "{}: {}\n", choice.address,
        choice.complete ? "no solution makes this choice" : "not found out, a limit came first");
  }
  std::string text;
  if (choice.listed) {
    text = fmt::format("{}: {}", choice.address, listed(choice.values, choice));
    if (choice.complete && !choice.missing.empty())
      text += fmt::format("; never {}", listed(choice.missing, choice));
  } else {
    text = fmt::format("{}: from {} to {}, of {} to {}", choice.address, choice.values.front(),
                       choice.values.back(), choice.from, choice.to);
  }
  if (!choice.complete) text += "; perhaps others, a limit came first";
  return text + "\n";
}

Condition frozen_condition(const solitaire::Condition& condition, const ExplanationContext& context) {
  Condition made{kind_of(condition),
                 place_of(condition.span, context.sources),
                 context.addresses.text(condition.address),
                 words_of(condition, context),
                 condition.message,
                 {}};
  if (const solitaire::Pin* pin = condition.pin) {
    made.pin = Pin{pin->pattern.text(), {}, pin->forbidden, pin->source, pin->element};
    if (pin->value) made.pin->value = api::frozen(*pin->value);
  }
  return made;
}

}  // namespace

Conflict frozen(const solitaire::Conflict& conflict, const ExplanationContext& context) {
  Conflict made{conflict.minimal,
                {},
                reason_of(conflict),
                conflict_text(conflict, context, false),
                conflict_text(conflict, context, true)};
  for (const solitaire::Condition& condition : conflict.members)
    made.members.push_back(frozen_condition(condition, context));
  return made;
}

DeadAsserts frozen(const solitaire::DeadAsserts& asserts, const SourceSet& sources) {
  DeadAsserts made{{}, asserts.undecided, dead_text(asserts, sources)};
  for (const solitaire::DeadAssert& each : asserts.dead)
    made.dead.push_back({place_of(each.span, sources), each.met});
  return made;
}

ReachableValues frozen(const solitaire::ReachableValues& choice, const AddressTable& addresses) {
  ReachableValues made;
  made.address = addresses.text(choice.address);
  made.from = choice.domain.lo;
  made.to = choice.domain.hi;
  made.step = choice.domain.step;
  made.is_bool = choice.domain.type() == Type::kBool;
  const bool all_known = std::ranges::none_of(choice.elements, &std::string::empty);
  if (all_known) made.elements = choice.elements;
  made.listed = choice.listed;
  made.complete = choice.complete;
  made.pinned = choice.pinned;
  made.restricted = choice.restricted();
  made.values.assign(choice.values.begin(), choice.values.end());
  if (choice.listed) made.missing = missing_values(choice);
  made.text = values_text(made);
  return made;
}

}  // namespace solitaire::api
