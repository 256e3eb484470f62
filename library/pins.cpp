#include "library/pins.h"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <solitaire/error.h>

#include "library/former_addresses.h"
#include "library/freeze.h"
#include "library/solution_file.h"

namespace solitaire::api {
namespace {

[[noreturn]] void refuse(const std::string& why) { throw Error(Error::Kind::kUsage, why); }

template <class Number>
std::optional<Number> read_number(const std::string& text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

/// Returns the number or bool that a text is, or nothing if it is another text.
std::optional<ChoiceValue> parse_value(const std::string& text, const std::string& source) {
  if (text == "true" || text == "false") return text == "true";
  if (const auto number = read_number<std::int64_t>(text); number && is_exact(*number)) return *number;
  const bool is_int = !text.empty() && text.find_first_not_of("+-0123456789") == std::string::npos;
  if (is_int || text.empty())
    refuse(fmt::format("{}: '{}' is no value of a choice", source, text) +
           (is_int ? ", whose ints have 62 bits" : "; an empty text is \"\""));
  const auto real = read_number<double>(text);
  if (real && std::isfinite(*real)) return *real;
  return std::nullopt;
}

/// The patterns of which choices of a pin file are kept, and which of them matched any.
class Keep {
 public:
  explicit Keep(const std::vector<std::string>& patterns) : used_(patterns.size(), false) {
    for (const std::string& pattern : patterns) patterns_.emplace_back(pattern);
  }

  bool matches(const AddressPattern& address) {
    addresses_.push_back(address.steps());
    bool kept = patterns_.empty();
    for (std::size_t i = 0; i < patterns_.size(); ++i) {
      if (!matches_part(patterns_[i], address.steps())) continue;
      used_[i] = true;
      kept = true;
    }
    return kept;
  }

  void require_used(const std::string& file) const {
    for (std::size_t i = 0; i < patterns_.size(); ++i) {
      if (used_[i]) continue;
      const auto nearest = nearest_patterns(patterns_[i], addresses_, 3);
      refuse(
          fmt::format("--keep '{}' matches no choice of {}{}", patterns_[i].text(), file,
                      nearest.empty() ? "" : fmt::format("; the nearest are {}", fmt::join(nearest, ", "))));
    }
  }

 private:
  /// What the pattern matches is kept with all below it.
  static bool matches_part(const AddressPattern& pattern, std::vector<std::string> steps) {
    for (; !steps.empty(); steps.pop_back()) {
      if (pattern.matches(steps)) return true;
    }
    return false;
  }

  std::vector<AddressPattern> patterns_;
  std::vector<bool> used_;
  std::vector<std::vector<std::string>> addresses_;  // of all choices of the file
};

void add_pins_of_file(const Program& program, const Options& options, std::vector<solitaire::Pin>& pins) {
  const std::string file = options.pin_file.string();
  Keep keep(options.keep);
  std::vector<Choice> choices = choices_of(read_solution_file(options.pin_file), file);
  name_as_today(program, choices);
  for (const Choice& choice : choices) {
    const AddressPattern address(choice.address);
    if (keep.matches(address)) {
      const std::string source = fmt::format("--pin-file {} ({})", file, choice.address);
      pins.push_back({address, scalar_of(choice.value), false, source});
    }
  }
  keep.require_used(file);
}

}  // namespace

std::string Pin::text() const {
  return fmt::format("{}={}", pattern, element.empty() && value ? to_text(*value) : element);
}

Pin parse_pin(const std::string& text, bool forbidden, const std::string& source) {
  const bool is_quoted = !text.empty() && text.back() == '"';  // may hold the sign itself
  const std::size_t sign = is_quoted ? text.find("=\"") : text.rfind('=');
  if (sign == std::string::npos || sign == 0) refuse(source + " is not of the form ADDRESS=VALUE");
  std::string value = text.substr(sign + 1);
  return {text.substr(0, sign), parse_value(value, source), forbidden, source, std::move(value)};
}

std::vector<solitaire::Pin> pins_of(const Program& program, const Options& options) {
  std::vector<solitaire::Pin> pins;
  for (const Pin& pin : options.pins) {
    pins.push_back({AddressPattern(pin.pattern), {}, pin.forbidden, pin.source, pin.element});
    if (pin.value) pins.back().value = scalar_of(*pin.value);
  }
  if (!options.pin_file.empty()) add_pins_of_file(program, options, pins);
  return pins;
}

}  // namespace solitaire::api
