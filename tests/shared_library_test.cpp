#include "smt/z3/shared_library.h"

#include <doctest/doctest.h>
#include <stdexcept>

using namespace solitaire;

TEST_CASE("shared libraries: one that is not there, or lacks a function, is named") {
  CHECK_THROWS_WITH_AS(SharedLibrary("/nowhere/libnone.so"),
                       doctest::Contains("/nowhere/libnone.so is needed and cannot be loaded"),
                       std::runtime_error);
  const SharedLibrary library("libm.so.6");
  CHECK(reinterpret_cast<double (*)(double)>(library.symbol("sqrt"))(49.0) == 7.0);
  CHECK_THROWS_WITH_AS(library.symbol("no_such_function"), doctest::Contains("no_such_function"),
                       std::runtime_error);
}
