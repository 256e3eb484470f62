#include "smt/z3/z3_api.h"

namespace solitaire {

const SharedLibrary& z3_library() {
  static const SharedLibrary library(SOLITAIRE_Z3_LIBRARY);
  return library;
}

}  // namespace solitaire
