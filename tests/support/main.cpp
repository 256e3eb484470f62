#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include "base/large_stack.h"

// Tests of deep recursion need the stack that the program itself runs on.
int main(int argc, char** argv) {
  int status = 0;
  solitaire::run_on_large_stack([&] { status = doctest::Context(argc, argv).run(); });
  return status;
}
