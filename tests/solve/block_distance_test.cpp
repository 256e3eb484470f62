// What blocks of solutions find that do not know each other is kept apart, and nothing of it is lost.
#include "engines/solve/block_distance.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "engines/tuning.h"

namespace solitaire {
namespace {

/// A solution with a choice for each letter.
Solution solution_of(const std::string& letters) {
  Solution solution;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    solution.choices.push_back(
        {fmt::format("x[{}]", i), Distribution::Family::kRange, TypedScalar::of(std::int64_t{letters[i]})});
  }
  return solution;
}

std::string letters_of(const Solution& solution) {
  std::string letters;
  for (const ChosenValue& choice : solution.choices) letters += static_cast<char>(choice.value.as_int());
  return letters;
}

/// Gives these solutions, one after the other.
class Given {
 public:
  explicit Given(std::vector<std::string> all) : all_(std::move(all)) {}
  BlockDistance::Find find() {
    return [this]() -> std::optional<Solution> {
      if (given_ == all_.size()) return std::nullopt;
      return solution_of(all_[given_++]);
    };
  }
  std::size_t given() const { return given_; }

 private:
  std::vector<std::string> all_;
  std::size_t given_ = 0;
};

/// Keeps away from these.
BlockDistance away_from(const std::vector<std::string>& others) {
  BlockDistance distance(tuning::kNearSolutions);
  for (const std::string& each : others) distance.add(solution_of(each));
  distance.start_block();
  return distance;
}

TEST_CASE("block distance: what is near a solution of before is put aside, and comes last") {
  BlockDistance distance = away_from({"aaaaaaaaaa", "bbbbbbbbbb"});
  Given found({"aaaaaaaaac", "bbbbbbbbcc", "aaaaaaaccc"});
  const auto first = distance.next(found.find());
  REQUIRE(first);
  CHECK(letters_of(*first) == "aaaaaaaccc");  // the first that is 0.3 away from both
  CHECK_FALSE(distance.next(found.find()));
  CHECK(letters_of(*distance.take_aside()) == "bbbbbbbbcc");
  CHECK(letters_of(*distance.take_aside()) == "aaaaaaaaac");
  CHECK_FALSE(distance.take_aside());
}

TEST_CASE("block distance: where all are near, the farthest will do, and it is tried more rarely") {
  BlockDistance distance = away_from({"aaaaaaaaaa"});
  std::vector<std::string> near;
  for (char letter = 'b'; letter <= 'z'; ++letter) near.push_back(std::string(9, 'a') + letter);
  near[2] = "aaaaaaaazz";
  Given found(near);
  CHECK(letters_of(*distance.next(found.find())) == "aaaaaaaazz");
  CHECK(found.given() == 4);
  CHECK(letters_of(*distance.next(found.find())) == "aaaaaaaaab");  // put aside before
  CHECK(found.given() == 4);
  distance.next(found.find());
  CHECK(found.given() == 8);  // tried again, in vain
  for (int i = 0; i < 3; ++i) distance.next(found.find());
  CHECK(found.given() == 8);  // five were put aside
}

TEST_CASE("block distance: a new block forgets what was put aside, and the first block has all it finds") {
  BlockDistance distance = away_from({});
  Given found({"aa", "aa", "ab"});
  const auto first = distance.next(found.find());
  distance.add(*first);
  CHECK(letters_of(*distance.next(found.find())) == "aa");  // nothing is known of other blocks
  distance.start_block();
  CHECK(letters_of(*distance.next(found.find())) == "ab");  // 0.5 away
  Given near({"aa", "bb"});
  CHECK(letters_of(*distance.next(near.find())) == "bb");
  distance.start_block();
  CHECK_FALSE(distance.take_aside());
}

}  // namespace
}  // namespace solitaire
