#include "tracegraph/address_pattern.h"

#include <doctest/doctest.h>
#include <random>
#include <string>
#include <string_view>

#include "tracegraph/address.h"

namespace solitaire {
namespace {

bool matches(const std::string& pattern, const std::string& address) {
  return AddressPattern(pattern).matches(AddressPattern(address).steps());
}

TEST_CASE("address pattern: an address matches itself and no other") {
  for (const char* address : {"x", "x#2", "wing[2]/room[0]/make_table/turn", "cells[1][12]"}) {
    CAPTURE(address);
    CHECK(matches(address, address));
    CHECK(!matches(address, std::string(address) + "/x"));
    CHECK(!matches(address, std::string("x/") + address));
    CHECK(!matches(address, std::string(address) + "x"));
  }
  CHECK(!matches("x", "x[0]"));
  CHECK(!matches("x", "x#2"));
  CHECK(!matches("x[1]", "x[12]"));
  CHECK(!matches("wing/x", "wing[0]/x"));
}

TEST_CASE("address pattern: a star stands for a part of a name or for the number of a turn") {
  CHECK(matches("*", "x"));
  CHECK(matches("*", "x#2"));
  CHECK(matches("make_*/x", "make_table/x"));
  CHECK(matches("*_*/x", "make_table/x"));
  CHECK(matches("wing[*]/x", "wing[12]/x"));
  CHECK(matches("cells[*][*]", "cells[1][12]"));
  CHECK(matches("cells[1][*]", "cells[1][12]"));
  CHECK(matches("x*", "x"));
  CHECK(matches("x[1*]", "x[12]"));
  CHECK(!matches("*", "x[0]"));
  CHECK(!matches("*", "a/x"));
  CHECK(!matches("wing[*]/x", "wing/x"));
  CHECK(!matches("wing[*]/x", "wing[1][2]/x"));
  CHECK(!matches("cells[2][*]", "cells[1][2]"));
  CHECK(!matches("*/x", "wing[0]/x"));
  CHECK(matches("*[*]/x", "wing[0]/x"));
}

TEST_CASE("address pattern: two stars stand for any number of steps") {
  CHECK(matches("**", "x"));
  CHECK(matches("**", "wing[2]/room[0]/x"));
  CHECK(matches("**/x", "x"));
  CHECK(matches("**/x", "wing[2]/room[0]/x"));
  CHECK(matches("wing[*]/**", "wing[2]/room[0]/x"));
  CHECK(matches("wing[*]/**", "wing[2]"));
  CHECK(matches("wing[*]/**/x", "wing[2]/x"));
  CHECK(matches("**/room[0]/**", "wing[2]/room[0]/x"));
  CHECK(matches("**/**/x", "x"));
  CHECK(!matches("**/x", "wing[2]/y"));
  CHECK(!matches("wing[1]/**", "wing[2]/x"));
  CHECK(!matches("**/room[0]/*", "wing[2]/room[0]/table/x"));
}

TEST_CASE("address pattern: many stars do not take long") {
  std::string pattern = "**", address = "a";
  for (int i = 0; i < 40; ++i) {
    pattern += "/**";
    address += "/a";
  }
  CHECK(!matches(pattern + "/b", address));
  CHECK(matches(pattern, address));
}

TEST_CASE("address pattern: stars between names do not take long") {
  std::string pattern, address, step = "a";
  for (int i = 0; i < 40; ++i) {
    pattern += "**/a/";
    address += "a/";
    step += "a";
  }
  address += address;
  CHECK(!matches(pattern + "y", address + "x"));
  CHECK(matches(pattern + "x", address + "x"));
  CHECK(!matches("*a*a*a*a*a*a*a*a*a*a*a*a*a*a*a*a*a*a*a*a*b", step + step + "[1]"));
}

/// What a pattern means, said without regard to how long it takes.
bool means(std::string_view pattern, std::string_view step) {
  if (pattern.empty()) return step.empty();
  if (pattern.front() != '*')
    return !step.empty() && step.front() == pattern.front() && means(pattern.substr(1), step.substr(1));
  const bool within = !step.empty() && step.front() != '[' && step.front() != ']';
  return means(pattern.substr(1), step) || (within && means(pattern, step.substr(1)));
}

TEST_CASE("address pattern: stars within a step match whatever the rule says, wherever they stand") {
  std::mt19937 random(1);
  int matched = 0;
  const auto text = [&](const char* letters, std::size_t kinds) {
    std::string made;
    for (std::size_t i = random() % 7; i > 0; --i) made += letters[random() % kinds];
    return made;
  };
  for (int i = 0; i < 20'000; ++i) {
    const std::string pattern = text("ab[]**", 6), step = text("ab[]", 4);
    if (pattern == "**") continue;
    CAPTURE(pattern);
    CAPTURE(step);
    CHECK(AddressPattern(pattern).matches({step}) == means(pattern, step));
    matched += means(pattern, step) ? 1 : 0;
  }
  CHECK(matched > 500);
}

TEST_CASE("address pattern: steps are split as those of addresses") {
  AddressTable addresses;
  const AddressId address =
      addresses.site(addresses.turn(addresses.site(AddressTable::root(), "wing"), 2), "x#2");
  CHECK(AddressPattern(addresses.text(address)).steps() == addresses.steps(address));
  CHECK(AddressPattern("wing[*]/**").matches(addresses.steps(address)));
}

}  // namespace
}  // namespace solitaire
