// A traced execution says, by the nodes of its values, what executions with other values of the choices come
// to. Every such claim is checked by running them.
#include <algorithm>
#include <doctest/doctest.h>
#include <map>

#include "engines/random_choices.h"
#include "solitaire/run/evaluator.h"
#include "solitaire/run/trace_reading.h"
#include "tests/generator/program_generator.h"
#include "tests/support/program_run.h"
#include "tracegraph/assignment.h"

namespace solitaire {
namespace {

/// Answers at random, or as another execution did where that met the choice.
class ChangedChoices : public Choices {
 public:
  ChangedChoices(std::map<AddressId, TypedScalar> known, RandomStream stream)
      : known_(std::move(known)), stream_(stream) {}

  std::optional<TypedScalar> answer(AddressId address, const Distribution& domain) override {
    const auto it = known_.find(address);
    if (it != known_.end() && domain.contains(it->second)) return it->second;
    return domain.sample(stream_);
  }

 private:
  std::map<AddressId, TypedScalar> known_;
  RandomStream stream_;
};

/// A traced execution does without the output.
const Value& value_without_output(const Execution& execution) {
  return execution.before_output.is<Value::Unset>() ? execution.value : execution.before_output;
}

std::map<AddressId, TypedScalar> values_of(const Execution& execution) {
  std::map<AddressId, TypedScalar> values;
  for (const MetChoice& choice : execution.choices) values[choice.address] = choice.value;
  return values;
}

/// What `value` of a traced execution is where its choices are those of another one.
std::string text_under(Assignment& assignment, const Value& value) {
  const auto other = value_under(assignment, value);
  return other ? to_text(*other) : "nothing";
}

struct Check {
  int same_path = 0;   // executions that the trace says everything about
  int other_path = 0;  // executions that leave its path
};

/// Traces random executions, changes some of their choices, and compares what the trace says with what an
/// execution with the changed choices does.
void check_traces(const Program& program, Check& check, std::uint64_t seed, int count) {
  for (int i = 0; i < count; ++i) {
    Graph graph;
    AddressTable addresses;
    Limits limits;
    limits.max_steps = 20'000;
    RandomStream stream(seed, Purpose::kExplore, static_cast<std::uint64_t>(i));
    RandomChoices random(stream);
    std::optional<TracedExecution> traced;
    try {
      traced = trace_execution(program, {}, random, graph, addresses, limits);
    } catch (const ProgramError&) {
      continue;
    }
    std::map<AddressId, TypedScalar> kept = values_of(traced->execution);
    Execution plain;
    try {
      ChangedChoices same(kept, stream);
      plain = execute(program, {}, same, addresses, limits);
    } catch (const ProgramError&) {
      CHECK(program.output() != nullptr);  // which a traced execution does without
      continue;
    }
    CHECK(to_text(value_without_output(plain)) == to_text(traced->execution.value));
    CHECK(plain.choices.size() == traced->execution.choices.size());
    CHECK(plain.rejection.has_value() == traced->execution.rejection.has_value());

    if (kept.empty()) continue;
    kept.erase(std::next(kept.begin(), static_cast<std::ptrdiff_t>(stream.below(kept.size()))));
    ChangedChoices changed(kept, RandomStream(seed + 1, Purpose::kExplore, static_cast<std::uint64_t>(i)));
    std::optional<Execution> other;
    try {
      other = execute(program, {}, changed, addresses, limits);
    } catch (const ProgramError&) {
      continue;  // a path that the trace says nothing about
    }
    const auto values = values_of(*other);
    Assignment assignment(graph, [&](std::size_t number) {
      const auto it = values.find(graph.variables()[number].address);
      return it == values.end() ? Scalar::of(std::int64_t{0}) : it->second.scalar();
    });
    const auto holds = [&](const auto& all, const auto member) {
      return std::all_of(all.begin(), all.end(),
                         [&](const auto& each) { return assignment.holds(each.*member); });
    };
    const bool comes_to_its_end = !traced->execution.rejection;
    if (!comes_to_its_end || !holds(traced->path, &PathCondition::holds)) {
      ++check.other_path;
      continue;
    }
    ++check.same_path;
    const bool fulfilled = holds(traced->trace.hard_terms, &Term::node);
    CHECK(fulfilled == !other->rejection.has_value());
    if (!fulfilled) continue;
    CHECK(other->choices.size() == traced->execution.choices.size());
    CHECK(text_under(assignment, traced->execution.value) == to_text(value_without_output(*other)));
    std::int64_t cost = 0;
    for (const Term& wish : traced->trace.soft_terms) cost += assignment.value(wish.node)->i;
    CHECK(cost == other->cost);
  }
}

}  // namespace

TEST_CASE("tracing: what a traced execution says of others is what they do") {
  const char* const texts[] = {
      "x = range(0, 9); y = range(0, 9); assert(x < y + 3); minimize(x * y); return [x + y, x == y, -x, "
      "abs(x - y)];",
      "x = range(0, 3); if x > 1 then y = x * 2 else y = 7; return [y, cond(x == 2, [x, 1], [2, 3])];",
      "xs = [range(0, 9) for i in 1..4]; i = range(0, 3); return [xs[i], min(xs), max(xs), sum(xs), "
      "distinct(xs)];",
      "xs = [1, 2, 3]; i = range(0, 4); xs[i] = 9; return xs;",
      "a = choose([1, [2], \"three\"]); return a;",
      "n = range(0, 3); t = 0; for i in 1..n { t += range(0, i); } return [t, str(n), [k * k for k in "
      "0..n]];",
      "record P(x, y); p = choose([P(1, 2), P(3, 4)]); q = P(range(0, 2), 0); q.x += p.y; return [q, p == "
      "q];",
      "x = range(0, 9); y = range(x, 12); z = range(0, 20, 5); return [x % 3, y / (x + 1), all(x < y, z > "
      "3)];",
      "b = flip(); c = flip(); return [b and c, b or not c, any(b, c), b == c];",
      "fun f(n) { if n == 0 then return 0; return n + f(n - 1); } return f(range(0, 4));",
  };
  Check check;
  std::uint64_t seed = 1;
  for (const char* text : texts) {
    CAPTURE(text);
    check_traces(program_of(text), check, seed++, 60);
  }
  CHECK(check.same_path > 150);
  CHECK(check.other_path > 30);
}

TEST_CASE("tracing: it says what generated programs do") {
  Check check;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    ByteSource bytes(seed);
    const std::string text = generate_script(bytes);
    CAPTURE(text);
    check_traces(program_of(text), check, seed, 5);
  }
  CHECK(check.same_path > 50);
}

TEST_CASE("tracing: floats are chosen, and conditions on them are followed") {
  const Program program = program_of(
      "x = uniform(0, 1); y = normal(0, 2); b = flip(0.25);"
      "if x > 0.5 then z = x * 2 else z = y; assert(z < 100.0); return [z, x + y, b];");
  int above = 0;
  for (std::uint64_t i = 0; i < 50; ++i) {
    Graph graph;
    AddressTable addresses;
    RandomChoices random(RandomStream(3, Purpose::kExplore, i));
    const TracedExecution traced = trace_execution(program, {}, random, graph, addresses, {});
    REQUIRE(traced.execution.choices.size() == 3);
    REQUIRE(traced.path.size() == 1);
    REQUIRE(traced.trace.hard_terms.size() == 1);
    CHECK(graph.node(traced.path[0].holds).has_float);
    const double x = traced.execution.choices[0].value.as_float();
    const Value& z = traced.execution.value.as_list()->items[0];
    CHECK(z.traced());
    CHECK(z.node() == traced.trace.returned[0]);
    if (x > 0.5) CHECK(*z.get<double>() == x * 2);
    above += x > 0.5 ? 1 : 0;
    const double sum = *traced.execution.value.as_list()->items[1].get<double>();
    CHECK(sum == x + traced.execution.choices[1].value.as_float());
  }
  CHECK(above > 10);
  CHECK(above < 40);
}

TEST_CASE("tracing: one machine runs many executions, as new ones do") {
  const Program program = program_of(
      "fun walk(n) { if n == 0 or flip() then return []; return [range(0, 9)] + walk(n - 1); }"
      "ps = walk(5); fs = [fun() { return i; } for i in ps]; assert(length(ps) != 3); minimize(length(ps));"
      "for p in ps { place(\"chair\", at: [p, 0]); print(p); } return [f() for f in fs];");
  AddressTable addresses, others;
  const ParamValues params;
  Executor executor(program, params, addresses, {});
  for (std::uint64_t i = 0; i < 100; ++i) {
    RandomChoices random(RandomStream(5, Purpose::kExplore, i));
    RandomChoices again(RandomStream(5, Purpose::kExplore, i));
    Execution& reused = executor.run(random);
    add_texts(reused, program, addresses);
    const Execution fresh = execute(program, params, again, others, {});
    CHECK(to_text(reused.value) == to_text(fresh.value));
    CHECK(reused.printed == fresh.printed);
    CHECK(reused.cost == fresh.cost);
    CHECK(reused.rejection.has_value() == fresh.rejection.has_value());
    REQUIRE(reused.choices.size() == fresh.choices.size());
    for (std::size_t c = 0; c < fresh.choices.size(); ++c)
      CHECK(addresses.text(reused.choices[c].address) == others.text(fresh.choices[c].address));
    REQUIRE(reused.placements.size() == fresh.placements.size());
    for (std::size_t p = 0; p < fresh.placements.size(); ++p)
      CHECK(reused.placements[p].address == fresh.placements[p].address);
  }
}

}  // namespace solitaire
