// Solutions are plain data that outlives whatever made them, and streams say what they can do.
#include "engines/solution.h"

#include <doctest/doctest.h>
#include <thread>

#include "engines/count/uniform_series.h"
#include "engines/solve/series.h"
#include "tests/support/program_run.h"

namespace solitaire {
namespace {

constexpr const char* kEverything =
    "record Seat(name, x);\n"
    "fun f() { return 1; }\n"
    "x = range(3, 4);\n"
    "place(\"chair\", at: [x, 0], name: \"first\", price: 2.5);\n"
    "print(\"x is\", x);\n"
    "return [Seat(\"a \\\"b\\\"\", x), [], nil, 0.5, 2.0, flip() or true, f, Seat];\n";

/// A stream that knows no program, and has nothing but what every stream has.
class Numbers : public SolutionStream {
 public:
  std::optional<Solution> next() override {
    if (next_ == 3) return std::nullopt;
    Solution solution;
    solution.value.is = next_++;
    return solution;
  }
  Ending ending() const override { return next_ == 3 ? Ending::kExhausted : Ending::kNone; }

 private:
  std::int64_t next_ = 0;
};

}  // namespace

TEST_CASE("solution: it stays what it is when its engine and its program are gone") {
  std::optional<Solution> solution;
  {
    const Program program = program_of(kEverything);
    TracingOptions options;
    options.pins = {{AddressPattern("x"), TypedScalar::of(std::int64_t{3}), false, "the test"}};
    TracingEngine engine(program, {}, options);
    solution = engine.next();
    REQUIRE(engine.next());
  }
  REQUIRE(solution);
  CHECK(to_text(solution->value) ==
        R"([Seat(name: "a \"b\"", x: 3), [], nil, 0.5, 2.0, true, fun f, record Seat])");
  CHECK(to_json(solution->value) ==
        R"([{"name":"a \"b\"","x":3},[],null,0.5,2.0,true,"fun f","record Seat"])");
  REQUIRE(solution->choices.size() == 2);
  CHECK(solution->choices[0].address == "x");
  CHECK(solution->choices[0].value == TypedScalar::of(std::int64_t{3}));
  CHECK(solution->choices[1].value.type() == Type::kBool);
  REQUIRE(solution->placements.size() == 1);
  CHECK(solution->placements[0].asset == "chair");
  CHECK(solution->placements[0].name == "first");
  CHECK(solution->placements[0].source == "test.sol:4:1");
  CHECK(solution->placements[0].choices.empty());  // what is pinned is no choice any more
  CHECK(solution->placements[0].extras == std::vector<std::pair<std::string, std::string>>{{"price", "2.5"}});
  CHECK(solution->printed == std::vector<std::string>{"x is 3"});
}

TEST_CASE("solution: other threads may copy it while the engine goes on") {
  const Program program = program_of("x = [range(0, 9) for i in 0..3];\nreturn [x, x, \"text\"];\n");
  TracingEngine engine(program, {}, {});
  std::vector<std::string> texts;
  std::vector<std::thread> threads;
  const std::optional<Solution> first = engine.next();
  REQUIRE(first);
  const std::string expected = to_json(first->value);
  texts.resize(4);
  for (std::string& text : texts) {
    threads.emplace_back([&] {
      for (int i = 0; i < 200; ++i) {
        const Solution copy = *first;
        text = to_json(copy.value);
      }
    });
  }
  for (int i = 0; i < 20; ++i) CHECK(engine.next());
  for (std::thread& thread : threads) thread.join();
  for (const std::string& text : texts) CHECK(text == expected);
}

TEST_CASE("solution: a stream says what it can do, and one without a program needs nothing of it") {
  Numbers numbers;
  SolutionStream& stream = numbers;
  CHECK(ability_of<Resumable>(stream) == nullptr);
  CHECK(ability_of<WithFormula>(stream) == nullptr);
  CHECK(ability_of<Exploring>(stream) == nullptr);
  std::string values;
  while (const auto solution = stream.next()) values += to_text(solution->value);
  CHECK(values == "012");

  const Program program = program_of("return range(0, 3);");
  Series series(program, {}, {}, {});
  UniformSeries uniform(program, {}, {}, Apart::kChoices);
  ExhaustiveEngine everything(program, {}, {});
  CHECK(ability_of<Resumable>(series) != nullptr);
  CHECK(ability_of<Improving>(series) != nullptr);
  CHECK(ability_of<WithFormula>(series) != nullptr);
  CHECK(ability_of<Resumable>(uniform) != nullptr);
  CHECK(ability_of<WithFormula>(uniform) == nullptr);
  CHECK(ability_of<Resumable>(everything) == nullptr);
}

}  // namespace solitaire
