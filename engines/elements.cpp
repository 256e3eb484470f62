#include "engines/elements.h"

#include <algorithm>
#include <vector>

#include "solitaire/value/elements.h"
#include "solitaire/value/plain_value.h"
#include "solitaire/value/short_text.h"

namespace solitaire {
namespace {

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

/// Calls `each` for every shape that a value has on some path.
template <class Each>
void for_each_shape(const Value& value, const Each& each) {
  const Union* several = value.as_union();
  if (several == nullptr) return each(value);
  for (const Union::Alternative& one : several->alternatives) for_each_shape(one.value, each);
}

/// Adds the texts of a list's elements, each once, in the order in which they stand, and a few at most.
void add_elements(const Elements& list, std::vector<std::string>& texts) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    for_each_shape(list.value(i), [&](const Value& one) {
      std::string text = short_text(one);
      const bool is_new = !text.empty() && std::ranges::find(texts, text) == texts.end();
      if (is_new && texts.size() <= kShortList) texts.push_back(std::move(text));
    });
  }
}

}  // namespace

bool means_element(const std::string& said, const std::string& element) {
  if (element.empty()) return false;
  if (said == element || json_string(said) == element || "fun " + said == element) return true;
  return element.back() == ']' || element.back() == ')' ? without_blanks(said) == without_blanks(element)
                                                        : false;
}

std::string elements_text(const Value& list) {
  std::vector<std::string> texts;
  for_each_shape(list, [&](const Value& one) {
    if (one.is_list()) add_elements(Elements(one), texts);
  });
  std::string joined;
  for (std::size_t i = 0; i < std::min(texts.size(), kShortList); ++i)
    joined += (i == 0 ? "" : ", ") + texts[i];
  return texts.size() > kShortList ? joined + ", ..." : joined;
}

}  // namespace solitaire
