#include <solitaire/solitaire.h>

#include "base/large_stack.h"

namespace solitaire::api {

const char* version() { return SOLITAIRE_VERSION; }

void run_on_large_stack(const std::function<void()>& work, const std::function<void()>& beside) {
  solitaire::run_on_large_stack(work, beside);
}

}  // namespace solitaire::api
