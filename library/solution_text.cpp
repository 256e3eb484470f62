#include <algorithm>
#include <fmt/format.h>
#include <solitaire/solution.h>

#include "base/counted.h"
#include "tracegraph/scalar.h"

namespace solitaire::api {

std::string to_text(const ChoiceValue& value) {
  return std::visit([](auto answer) { return solitaire::to_text(TypedScalar::of(answer)); }, value);
}

namespace {

constexpr std::size_t kMostWishes = 10;

/// Says which wishes cost something, in lines of their own.
std::string wishes_text(const std::vector<UnmetWish>& unmet) {
  std::string text;
  for (std::size_t i = 0; i < std::min(unmet.size(), kMostWishes); ++i)
    text += fmt::format("  unmet: {}\n", to_text(unmet[i]));
  if (unmet.size() > kMostWishes)
    text += fmt::format("  and {} other wishes that cost something\n", unmet.size() - kMostWishes);
  return text;
}

/// Says what is proved of a solution that is not proved the best.
std::string bound_text(const Quality& quality) {
  if (!quality.least_cost) return "";
  return quality.is_maximum ? fmt::format(", but none has more than {}", -*quality.least_cost)
                            : fmt::format(", but none costs less than {}", *quality.least_cost);
}

}  // namespace

std::string quality_text(const Solution& solution) {
  if (!solution.quality) return "";
  const Quality& quality = *solution.quality;
  std::string text;
  if (quality.broken > 0) text += counted(quality.broken, "assert") + " broken, ";
  if (quality.is_maximum) {
    text += fmt::format("maximum {}, ", -quality.cost);
  } else if (quality.wishes > 0) {
    text += fmt::format("cost {}, ", quality.cost);
  }
  if (quality.proved_best) return text + "proved the best left";
  return text + "not proved the best left" + bound_text(quality);
}

std::string to_text(const BrokenAssert& broken) {
  std::string text = fmt::format("{}: {} (at {})", broken.source, broken.condition, broken.address);
  if (!broken.message.empty()) text += ": " + broken.message;
  return text;
}

std::string to_text(const UnmetWish& wish) {
  return fmt::format("{}: {} (cost {})", wish.source, wish.text, wish.cost);
}

std::string to_text(const Solution& solution) {
  std::string text = fmt::format("solution {}: {}\n", solution.number, solution.text);
  if (solution.quality) text += fmt::format("  {}\n", quality_text(solution));
  text += wishes_text(solution.unmet);
  for (const BrokenAssert& broken : solution.broken) text += fmt::format("  broken: {}\n", to_text(broken));
  for (const Choice& choice : solution.choices)
    text += fmt::format("  {} = {}\n", choice.address,
                        choice.element.empty() ? to_text(choice.value) : choice.element);
  return text;
}

}  // namespace solitaire::api
