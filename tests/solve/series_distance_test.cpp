// What blocks of solutions find that do not know each other is kept apart, and nothing of it is lost.
#include "engines/solve/series_distance.h"

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
  SeriesDistance::Find find() {
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
SeriesDistance away_from(const std::vector<std::string>& others) {
  SeriesDistance distance(0.3, 3);
  for (const std::string& each : others) distance.add(solution_of(each));
  distance.start_block();
  return distance;
}

TEST_CASE("series distance: what is near a solution of before is put aside, and comes last") {
  SeriesDistance distance = away_from({"aaaaaaaaaa", "bbbbbbbbbb"});
  Given found({"aaaaaaaaac", "bbbbbbbbcc", "aaaaaaaccc"});
  const auto first = distance.next(found.find());
  REQUIRE(first);
  CHECK(letters_of(*first) == "aaaaaaaccc");  // the first that is 0.3 away from both
  CHECK_FALSE(distance.next(found.find()));
  CHECK(letters_of(*distance.take_aside()) == "bbbbbbbbcc");
  CHECK(letters_of(*distance.take_aside()) == "aaaaaaaaac");
  CHECK_FALSE(distance.take_aside());
}

TEST_CASE(
    "series distance: where all are near, the farthest will do, and then half the distance is asked for") {
  SeriesDistance distance = away_from({"aaaaaaaaaaaaaaaaaaaa"});
  const std::string a(17, 'a');
  Given found({a + "aab", a + "aac", a + "ddd", a + "aee", a + "fff", a + "agg", a + "aah"});
  const auto next = [&] {
    const auto taken = distance.next(found.find());
    REQUIRE(taken);
    distance.add(*taken);
    return letters_of(*taken).substr(17);
  };
  CHECK(next() == "ddd");  // of four, none of which is 0.3 away
  CHECK(found.given() == 4);
  CHECK(next() == "fff");  // the first that is 0.15 away
  CHECK(found.given() == 5);
  CHECK(next() == "aee");  // of four again
  CHECK(found.given() == 6);
  CHECK(next() == "agg");  // put aside before, and 0.075 away
  CHECK(found.given() == 6);
}

TEST_CASE("series distance: what was put aside comes once it is far enough") {
  SeriesDistance distance = away_from({"aaaaaaaaaa"});
  Given found({"aaaaaaaabb", "aaaaaaaacc", "aaaaaaaaad", "aaaaaaaaae"});
  std::vector<std::string> taken;
  for (int i = 0; i < 2; ++i) {
    const auto solution = distance.next(found.find());
    REQUIRE(solution);
    distance.add(*solution);
    taken.push_back(letters_of(*solution));
  }
  CHECK(taken == std::vector<std::string>{"aaaaaaaabb", "aaaaaaaacc"});
  CHECK(found.given() == 4);
}

TEST_CASE("series distance: what is asked for depends on what was added alone") {
  const std::string near(19, 'a'), other(20, 'z');
  SeriesDistance first = away_from({near + 'a'});
  Given found({near + 'b', near + 'c', near + 'd', near + 'e'});
  first.add(*first.next(found.find()));
  SeriesDistance second = away_from({near + 'a'});
  second.add(solution_of(near + 'b'));
  for (SeriesDistance* each : {&first, &second}) {
    each->start_block();
    Given rest({std::string(17, 'a') + "aff", std::string(17, 'a') + "ggg", other});
    const auto solution = each->next(rest.find());
    REQUIRE(solution);
    CHECK(letters_of(*solution) == std::string(17, 'a') + "ggg");  // 0.15 away
  }
}

TEST_CASE(
    "series distance: solutions of one block are kept apart, and a new one forgets what was put aside") {
  SeriesDistance distance = away_from({});
  Given found({"aaaaaaaaaa", "aaaaaaaaab", "bbbbbbbbbb"});
  const auto first = distance.next(found.find());
  REQUIRE(first);
  distance.add(*first);
  CHECK(letters_of(*distance.next(found.find())) == "bbbbbbbbbb");
  distance.start_block();
  CHECK_FALSE(distance.take_aside());
}

TEST_CASE("series distance: what was put aside may be near what came after it") {
  SeriesDistance distance = away_from({"aaaaaaaaaa"});
  Given found({"aaaaaaaabb", "aaaaaaaabd", "aaaaaaaaad", "aaaaaaaaea", "aaaaaaffaa"});
  const auto first = distance.next(found.find());
  REQUIRE(first);
  CHECK(letters_of(*first) == "aaaaaaaabb");  // 0.2 away, after which 0.15 is asked for
  distance.add(*first);
  const auto second = distance.next(found.find());
  REQUIRE(second);
  CHECK(letters_of(*second) == "aaaaaaffaa");  // for "aaaaaaaabd" is only 0.1 away from the first
}

TEST_CASE("series distance: once many came, all others come as they are found") {
  SeriesDistance distance(0.3, 3);
  for (std::size_t i = 0; i < tuning::kKeptApart; ++i) distance.add(solution_of(std::string(10, 'a')));
  Given found({std::string(10, 'a')});
  CHECK(distance.next(found.find()));
}

}  // namespace
}  // namespace solitaire
