#include "engines/engine.h"

namespace solitaire {

std::vector<AnsweredChoice> readable(const std::vector<MetChoice>& choices, const AddressTable& addresses) {
  std::vector<AnsweredChoice> result;
  result.reserve(choices.size());
  for (const MetChoice& choice : choices) {
    result.push_back({addresses.text(choice.address), choice.domain.family, choice.value});
  }
  return result;
}

}  // namespace solitaire
