#include "library/endings.h"

namespace solitaire::api {

Ending public_ending(solitaire::Ending ending) {
  switch (ending) {
    case solitaire::Ending::kNone:
      return Ending::kNone;
    case solitaire::Ending::kExhausted:
      return Ending::kExhausted;
    case solitaire::Ending::kUnexplored:
      return Ending::kUnexplored;
    case solitaire::Ending::kWrapped:
      return Ending::kWrapped;
    case solitaire::Ending::kStopped:
      break;
  }
  return Ending::kStopped;
}

}  // namespace solitaire::api
