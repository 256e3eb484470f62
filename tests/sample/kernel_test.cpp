// The laws of the kernel: it scores as the program does, a slice is all that changes, what is refused changes
// nothing, and forms are what the score looks like along a choice.
#include "kernel/kernel.h"

#include <cmath>
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <string>

#include "engines/sample/proposal.h"
#include "engines/sample/shred/conditional.h"
#include "kernel/called_operations.h"
#include "kernel/compiler.h"
#include "kernel/forms.h"
#include "kernel/machine.h"
#include "solitaire/value/plain_copy.h"
#include "tests/sample/traced.h"

namespace solitaire {
namespace {

using Scored = Kernel::Outcome;

constexpr const char* kTexts[] = {
    "m = normal(0, 3); s = gamma(2, 1); for y in [0.5, 1.5, 2.0]: observe(Normal(m, precision: s), y); "
    "return m, s;",
    "p = dirichlet([1, 2, 0.5]); k = [categorical(p) for i in 1..3]; q = [beta(1, 2) for i in 1..3];"
    "for i in 0..2: observe(Flip(q[k[i]]), i != 1); return p, k;",
    "n = range(1, 4); x = [uniform(0, n) for i in 1..2]; assert(x[0] + x[1] < 3); factor(-pow(x[0] - x[1], "
    "2));"
    "return n, x;",
    "r = exponential(2); c = poisson(r + 1); g = geometric(0.3); observe(Poisson(exp(0.1 * g) + c), 4);"
    "return if c > 1 then r else -r;",
    "a = flip(0.3); b = normal(cond(a, 1, -1), 1); prefer(b > 0, 2); return max(b, 0.5), floor(b);",
    "a = flip(0.4); x = normal(0, 1); if a then { observe(Normal(x, 1), 1.0); factor(0.1); } else factor(-x "
    "* x);"
    "if x > 1 then factor(0.3); return if a and x > 0 then x else 2 * x;",
    "a = flip(0.4); b = if a then normal(0, 1) else 0.5; return a, b;",
};

TEST_CASE("kernel: executions share a path where the sides of a branch only compute or weigh") {
  const auto branches = [](const char* text) { return Traced(text, 2).structure.branches; };
  CHECK(!branches(
      "a = flip(); x = normal(0, 1); return if a then x else if x > 1 then log(1 + x * x) else 0.0;"));
  CHECK(!branches(
      "x = normal(0, 1); if x > 0 then observe(Normal(x, 1), 2) else { factor(x); factor(-1); } return x;"));
  CHECK(branches("a = flip(); return if a then normal(0, 1) else 0.0;"));
  CHECK(branches("a = flip(); b = 0; if a then b = 1; return b;"));
  CHECK(branches("a = flip(); xs = [1, 2]; return if a then xs[1] else xs[2];"));
  // A side that makes a mistake where it is not taken.
  CHECK(branches("a = flip(1.0); if a then factor(1) else observe(Normal(0, -1), 2); return a;"));
}

TEST_CASE("kernel: the score is that of the execution, and outputs are what it returns") {
  for (const char* text : kTexts) {
    for (std::uint64_t seed = 1; seed < 6; ++seed) {
      INFO(text);
      Traced traced(text, seed);
      CHECK(traced.kernel().log_score() == doctest::Approx(traced.state.log_density()).epsilon(1e-12));
      std::vector<std::string> names;
      std::vector<double> numbers;
      ReturnedNumbers(traced.program).read(plain(traced.state.value), names, numbers);
      CHECK(traced.structure.names == names);
      CHECK(traced.kernel().outputs() == numbers);
    }
  }
}

/// Proposals of each choice, by the program and by the kernel.
TEST_CASE(
    "kernel: a proposal is scored as by running the program, and changes nothing until it is accepted") {
  std::size_t scored = 0, impossible = 0, left = 0;
  for (const char* text : kTexts) {
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
      INFO(text);
      Traced traced(text, seed);
      Kernel& kernel = traced.kernel();
      Proposer proposer(traced.stream);
      for (std::size_t i = 0; i < traced.state.choices.size(); ++i) {
        const MetChoice& choice = traced.state.choices[i];
        CHECK(kernel.distribution(i) == choice.domain);
        const Proposal proposal = proposer.propose(choice.address, choice.domain, choice.value);
        if (!choice.domain.contains(proposal.value) || kernel.program().choices[i].cell == kNoCell) continue;
        SampledState proposed;
        const double log_ratio = traced.rerun.propose(i, proposal, proposed);
        const double before = kernel.log_score();
        const Scored outcome = kernel.propose(i, proposal.value.scalar());
        CHECK(kernel.log_score() == before);
        CHECK(traced.structure.load(traced.state));
        CHECK(kernel.log_score() == before);
        if (outcome == Scored::kLeavesTrace) {
          ++left;
        } else if (outcome == Scored::kImpossible) {
          ++impossible;
          CHECK(log_ratio == -HUGE_VAL);
        } else {
          ++scored;
          REQUIRE(kernel.propose(i, proposal.value.scalar()) == Scored::kScored);
          CHECK(kernel.difference() + proposal.log_ratio == doctest::Approx(log_ratio).epsilon(1e-9));
          kernel.accept();
          CHECK(kernel.log_score() == doctest::Approx(proposed.log_density()).epsilon(1e-9));
          CHECK(traced.structure.load(proposed));
          CHECK(traced.structure.load(traced.state));
        }
      }
    }
  }
  CHECK(scored > 50);
  CHECK(impossible > 0);
  CHECK(left > 0);
}

TEST_CASE("forms: a choice between 0 and 1 has a known form only where these ends do not move") {
  for (std::uint64_t seed = 1; seed < 9; ++seed) {
    Traced moving("g = geometric(0.9); u = uniform(0, g + 1); return u;", seed);
    CHECK(moving.kernel().program().choices[1].form == Form::kUnknown);
  }
  Traced fixed("u = uniform(0, 1); observe(Flip(u), true); return u;", 1);
  CHECK(fixed.kernel().program().choices[0].form == Form::kBeta);
}

TEST_CASE("kernel: what a choice's distribution is made of is computed before the choice is met") {
  std::size_t computed = 0;
  const char* const ints =
      "g = geometric(0.4); u = uniform(g, g + 1); k = range(g, g + 3); c = choose([1, 2], weights: [g + 1, "
      "2]);"
      "return u, k, c;";
  for (const char* text : {kTexts[0], kTexts[1], kTexts[2], kTexts[3], kTexts[4], ints}) {
    INFO(text);
    Traced traced(text, 3);
    const ScoreProgram& program = traced.kernel().program();
    std::vector<bool> made(program.cells.size(), false);
    for (const Instruction& step : program.code) made[step.result] = true;
    for (const ScoreProgram::Choice& choice : program.choices) {
      for (const Cell parameter : choice.parameters) {
        CHECK((!made[parameter] || parameter < choice.cell));
        computed += made[parameter] ? 1 : 0;
      }
    }
  }
  CHECK(computed > 8);
}

TEST_CASE("kernel: a change of all floats is scored as by computing all anew") {
  std::size_t scored = 0;
  for (const char* text : kTexts) {
    INFO(text);
    Traced traced(text, 4);
    Kernel& kernel = traced.kernel();
    for (int round = 0; round < 5; ++round) {
      std::vector<Scalar> values;
      for (ChoiceNumber i = 0; i < kernel.program().choices.size(); ++i) values.push_back(kernel.value(i));
      std::vector<double> floats;
      for (const ChoiceNumber each : kernel.floats()) {
        floats.push_back(values[each].f * (1 + 0.02 * traced.stream.uniform()));
        values[each] = Scalar::of(floats.back());
      }
      if (kernel.propose_floats(floats) != Scored::kScored) continue;
      ++scored;
      kernel.accept();
      const double running = kernel.log_score();
      REQUIRE(kernel.load(values) == Scored::kScored);
      CHECK(running == doctest::Approx(kernel.log_score()).epsilon(1e-9));
    }
  }
  CHECK(scored > 10);
}

TEST_CASE("kernel: where a change of all floats makes the density infinite, it tells all values") {
  Traced traced(
      "a = flip(); x = normal(0, 1); y = normal(0, 1); for i in 1..2: factor(cond(x + y > 7, "
      "1.5e308, 0.0)); return a;",
      1);
  Kernel& kernel = traced.kernel();
  const std::vector<double> near{1, 1}, far{4, 4};
  CHECK(kernel.propose_floats(near) == Scored::kScored);
  CHECK(!kernel.take_infinite());
  CHECK(kernel.propose_floats(far) == Scored::kImpossible);
  const auto values = kernel.take_infinite();
  REQUIRE(values);
  CHECK((*values)[0].i == kernel.value(0).i);
  CHECK((*values)[1].f == 4);
  CHECK((*values)[2].f == 4);
  CHECK(kernel.load(*values) == Scored::kLeavesTrace);
}

TEST_CASE("kernel: after many accepted changes every cell is as if computed anew") {
  Traced traced(kTexts[1], 3);
  Kernel& kernel = traced.kernel();
  for (int step = 0; step < 500; ++step) {
    const ChoiceNumber choice = traced.stream.below(kernel.program().choices.size());
    const Scalar value = kernel.distribution(choice).sample(traced.stream).scalar();
    if (kernel.propose(choice, value) == Scored::kScored) kernel.accept();
  }
  const double running = kernel.log_score();
  std::vector<Scalar> values;
  for (ChoiceNumber i = 0; i < kernel.program().choices.size(); ++i) values.push_back(kernel.value(i));
  REQUIRE(kernel.load(values) == Scored::kScored);
  CHECK(running == doctest::Approx(kernel.log_score()).epsilon(1e-11));
}

std::vector<Form> forms_of(const char* text) {
  Traced traced(text, 2);
  std::vector<Form> forms;
  for (const ScoreProgram::Choice& choice : traced.kernel().program().choices) forms.push_back(choice.form);
  return forms;
}

TEST_CASE("forms: conjugate choices are known, also where the form is hidden, and others are not") {
  using enum Form;
  CHECK(forms_of(kTexts[0]) == std::vector{kNormal, kGamma});
  CHECK(forms_of("t = gamma(1, 1); observe(Normal(0, 1 / sqrt(t)), 0.7); return t;") == std::vector{kGamma});
  CHECK(forms_of("m = normal(0, 1); observe(Normal(2 * m + 1, 2), 0.7); return m;") == std::vector{kNormal});
  CHECK(forms_of("m = normal(0, 1); observe(Normal(m * m, 2), 0.7); return m;") == std::vector{kUnknown});
  CHECK(forms_of("s = exponential(1); observe(Normal(0, s), 0.7); return s;") == std::vector{kUnknown});
  CHECK(forms_of("r = gamma(2, 1); observe(Poisson(3 * r), 4); return r;") == std::vector{kGamma});
  CHECK(forms_of("p = uniform(0, 1); observe(Flip(1 - p), true); return p;") == std::vector{kBeta});
  CHECK(forms_of("p = uniform(0, 2); observe(Flip(p / 2), true); return p;") == std::vector{kUnknown});
  CHECK(forms_of("a = flip(); m = normal(0, 1); observe(Normal(cond(a, m, 3 * m), 2), 0.7); return m;") ==
        std::vector{kWeights, kNormal});
  CHECK(forms_of("m = normal(0, 1); observe(Normal(if m > 0 then 1 else 2, 2), 0.7); return m;") ==
        std::vector{kUnknown});
}

// Beside those of kTexts, programs in which forms are hidden, are shared, and have conditions.
constexpr const char* kFormTexts[] = {
    "k = choose([1, 2, 5]); m = normal(0, 1); factor(0.3 * k * m); return k, m;",
    "a = normal(0, 5); b = normal(0, 5); s = exponential(1); for x in 1..9: observe(Normal(a + b * x, s), 3 "
    "* x - "
    "1); return a, b, s;",
    "a = normal(0, 5); b = normal(0, 5); s = gamma(2, 1); for x in 1..9: observe(Normal(a + b * x, "
    "precision: s), "
    "3 * x - 1); return a, b, 1 / sqrt(s);",
    "m = normal(1, 2); t = gamma(2, 2); u = exponential(1); x = [normal(m, precision: t) for i in 1..4];"
    "for i in 0..3: observe(Normal(2 * x[i] - 1, 1 / sqrt(u)), i); return m, x, t;",
    "p = [dirichlet([1, 2, 3]) for k in 0..1]; q = uniform(0, 1); for w in [0, 2, 1, 1, 2] { z = flip(q); "
    "observe(Categorical(cond(z, p[0], p[1])), w); } return p, q;",
    "m = normal(0, 1); assert(m < 1.5); k = choose([1, 2, 5], weights: [1, 0, 2]); assert(k + m > 0.2); "
    "observe(Normal(k * m, 2), 1); factor(m); return m, k;",
    "s = [flip() for i in 1..6]; for i in 0..4: factor(cond(s[i] == s[i + 1], 0.7, -0.2)); return s;",
    "a = flip(); m = normal(0, 1); t = gamma(1, 1); if a then observe(Normal(m, 1 / sqrt(t)), 1.5) else "
    "factor(-t); return a, m, t;",
    "w = [normal(0, 1) for k in 0..2]; for x in 1..5: observe(Normal(w[0] * w[1] * x + w[2], 1), x); return "
    "w;",
    "r = gamma(2, 1); s = gamma(3, 1); observe(Poisson(3 * r * s), 4); observe(Exponential(r / s), 0.5); "
    "return r;",
    // The forms of a and b, which are not drawn together, share what follows from s.
    "a = normal(0, 5); b = normal(0, 5); s = exponential(1); assert(a > -9); assert(b > -9); for x in 1..9: "
    "observe(Normal(a + b * x, s), 3 * x - 1); return a, b, s;",
};

std::vector<const char*> texts_with_forms() {
  std::vector<const char*> texts(std::begin(kTexts), std::end(kTexts));
  texts.insert(texts.end(), std::begin(kFormTexts), std::end(kFormTexts));
  return texts;
}

double along(Form form, std::span<const double> numbers, double c) {
  if (form == Form::kNormal) return numbers[0] * c + numbers[1] * c * c;
  if (form == Form::kGamma) return numbers[0] * std::log(c) + numbers[1] * c;
  return numbers[0] * std::log(c) + numbers[1] * std::log1p(-c);
}

/// Compares the numbers of a form with what the density becomes.
int compare_form(Traced& traced, ChoiceNumber choice) {
  Kernel& kernel = traced.kernel();
  const Form form = kernel.program().choices[choice].form;
  const Distribution distribution = kernel.distribution(choice);
  const std::span<const double> found = kernel.numbers(choice);
  const std::vector<double> numbers(found.begin(), found.end());
  const Scalar present = kernel.value(choice);
  if (form != Form::kWeights) {
    const Scalar value = distribution.sample(traced.stream).scalar();
    if (kernel.propose(choice, value) != Scored::kScored) return 0;
    const double expected = along(form, numbers, value.f) - along(form, numbers, present.f);
    CHECK(kernel.difference() == doctest::Approx(expected).epsilon(1e-8));
    return 1;
  }
  const auto number = static_cast<std::size_t>((present.i - distribution.lo) / distribution.step);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool possible = kernel.propose(choice, Scalar::of(distribution.value(i))) == Scored::kScored;
    CHECK(possible == std::isfinite(numbers[i]));
    if (possible) CHECK(kernel.difference() == doctest::Approx(numbers[i] - numbers[number]).epsilon(1e-9));
  }
  return 1;
}

/// Compares a proposal with that of a kernel in which nothing was left behind.
void compare_with_new(const Kernel& kernel, ChoiceNumber choice, Scalar value) {
  Kernel anew(kernel.program(), false);
  std::vector<Scalar> values;
  for (ChoiceNumber i = 0; i < kernel.program().choices.size(); ++i) values.push_back(kernel.value(i));
  REQUIRE(anew.load(values) == Scored::kScored);
  REQUIRE(anew.propose(choice, value) == Scored::kScored);
  CHECK(kernel.difference() == doctest::Approx(anew.difference()).epsilon(1e-9));
}

TEST_CASE("forms: their numbers are those of the density, after any changes") {
  int compared = 0;
  for (const char* text : texts_with_forms()) {
    INFO(text);
    for (std::uint64_t seed = 1; seed < 6; ++seed) {
      Traced traced(text, seed);
      Kernel& kernel = traced.kernel();
      for (int step = 0; step < 60; ++step) {
        const ChoiceNumber choice = traced.stream.below(kernel.program().choices.size());
        if (kernel.program().choices[choice].form != Form::kUnknown) {
          if (step % 4 == 0) compared += compare_form(traced, choice);
          if (const auto value = draw_of_form(kernel, choice, traced.stream)) kernel.set(choice, *value);
        } else if (kernel.program().choices[choice].cell != kNoCell) {
          const Scalar value = kernel.distribution(choice).sample(traced.stream).scalar();
          if (kernel.propose(choice, value) != Scored::kScored) continue;
          if (step % 4 == 0) compare_with_new(kernel, choice, value);
          kernel.accept();
        }
      }
    }
  }
  CHECK(compared > 200);
}

TEST_CASE("forms: after changes without a density all is as if computed anew") {
  for (const char* text : texts_with_forms()) {
    INFO(text);
    Traced traced(text, 7);
    Kernel& kernel = traced.kernel();
    const auto values = [&] {
      std::vector<Scalar> found;
      for (ChoiceNumber i = 0; i < kernel.program().choices.size(); ++i) found.push_back(kernel.value(i));
      return found;
    };
    for (int step = 0; step < 400; ++step) {
      const ChoiceNumber choice = traced.stream.below(kernel.program().choices.size());
      if (kernel.program().choices[choice].cell == kNoCell) continue;
      const bool by_form = kernel.program().choices[choice].form != Form::kUnknown && step % 3 != 0;
      if (by_form) {
        const std::vector<Scalar> before = values();
        const auto value = draw_of_form(kernel, choice, traced.stream);
        if (!value || kernel.set(choice, *value)) continue;
        for (ChoiceNumber i = 0; i < before.size(); ++i)
          CHECK(bits_of(before[i]) == bits_of(kernel.value(i)));
      } else {
        const Scalar value = kernel.distribution(choice).sample(traced.stream).scalar();
        if (kernel.propose(choice, value) == Scored::kScored) kernel.accept();
      }
    }
    const std::vector<double> outputs = kernel.outputs();
    kernel.refresh();
    const double running = kernel.log_score();
    REQUIRE(kernel.load(values()) == Scored::kScored);
    CHECK(running == doctest::Approx(kernel.log_score()).epsilon(1e-11));
    CHECK(outputs == kernel.outputs());
  }
}

TEST_CASE("forms: the density after a change that leaves no cell behind is that of the new value") {
  Traced traced("p = beta(2, 3); k = flip(p); c = poisson(3 * p + 1); return p, k, c;", 1);
  Kernel& kernel = traced.kernel();
  const double before = kernel.log_score();
  const double p = kernel.value(0).f;
  const bool k = kernel.value(1).i != 0;
  REQUIRE(kernel.program().choices[1].form == Form::kWeights);
  REQUIRE(kernel.set(1, Scalar::of(!k)));
  kernel.refresh();
  const double odds = std::log(p) - std::log(1 - p);
  CHECK(kernel.log_score() - before == doctest::Approx(k ? -odds : odds));
}

TEST_CASE("forms: of a sum over data only sums of the data are left") {
  std::string points;
  for (int i = 0; i < 200; ++i) points += fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", i, 3 * i % 17);
  const std::string text = fmt::format(
      "a = normal(0, 9); b = normal(0, 9); t = gamma(1, 1); for x, y in [{}]: observe(Normal(a + b * x, "
      "precision: t), y); return a, b;",
      points);
  Traced traced(text.c_str(), 1);
  for (const ChoiceNumber line : {0U, 1U}) CHECK(traced.kernel().upkeep().forms[line].size() < 10);
  CHECK(traced.kernel().upkeep().changes[0].size() + traced.kernel().upkeep().changes[1].size() < 10);
}

TEST_CASE("forms: the root of a square is not what was squared") {
  CHECK(forms_of("m = normal(0, 1); observe(Normal(sqrt(m * m), 2), 0.7); return m;") ==
        std::vector{Form::kUnknown});
}

/// The mean and standard deviation of draws of the first choice, all else being fixed.
std::pair<double, double> moments(const char* text) {
  Traced traced(text, 4);
  double sum = 0, squares = 0;
  constexpr int kDraws = 20'000;
  for (int i = 0; i < kDraws; ++i) {
    const auto value = draw_of_form(traced.kernel(), 0, traced.stream);
    REQUIRE(value);
    REQUIRE(traced.kernel().set(0, *value));
    sum += value->f;
    squares += value->f * value->f;
  }
  const double mean = sum / kDraws;
  return {mean, std::sqrt(squares / kDraws - mean * mean)};
}

TEST_CASE("forms: values drawn from them have the moments of the exact posterior") {
  // A normal prior with precision 1/9, three observations with precision 4 and mean 2.
  const auto [m, m_sd] =
      moments("m = normal(0, 3); for y in [1, 2, 3]: observe(Normal(m, 0.5), y); return m;");
  const double precision = 1.0 / 9 + 12;
  CHECK(m == doctest::Approx(24 / precision).epsilon(0.01));
  CHECK(m_sd == doctest::Approx(1 / std::sqrt(precision)).epsilon(0.02));
  // Gamma(2, 1) and Poisson counts 3 and 5 of twice the rate: Gamma(10, 5).
  const auto [r, r_sd] = moments("r = gamma(2, 1); for c in [3, 5]: observe(Poisson(2 * r), c); return r;");
  CHECK(r == doctest::Approx(10.0 / 5).epsilon(0.01));
  CHECK(r_sd == doctest::Approx(std::sqrt(10.0) / 5).epsilon(0.02));
  // Beta(1, 1), two heads and a tail: Beta(3, 2).
  const auto [p, p_sd] =
      moments("p = uniform(0, 1); for x in [true, true, false]: observe(Flip(p), x); return p;");
  CHECK(p == doctest::Approx(0.6).epsilon(0.01));
  CHECK(p_sd == doctest::Approx(0.2).epsilon(0.02));
}

/// Code, and the machine code that was made of it.
class BothMachines {
 public:
  explicit BothMachines(std::span<const Instruction> code, Cell shared_end = 0)
      : code_(code.begin(), code.end()), compiled_(compiler_.compile(code_, shared_end)) {
    CHECK(bool(compiled_) == Compiler::available());
  }

  /// Runs both on copies of the cells and compares all cells but results that do not last.
  void check(std::span<const Scalar> cells) const {
    if (!compiled_) return;
    std::vector<Scalar> interpreted(cells.begin(), cells.end()), found = interpreted;
    bool same = run(code_, interpreted.data()) == compiled_(found.data());
    for (const Instruction& step : code_)
      if (!step.lasts) found[step.result] = interpreted[step.result];
    for (std::size_t i = 0; i < found.size(); ++i) {
      const bool both_nan = std::isnan(found[i].f) && std::isnan(interpreted[i].f);
      same = same && (both_nan || found[i].i == interpreted[i].i);
    }
    CHECK(same);
  }

 private:
  std::vector<Instruction> code_;
  Compiler compiler_;
  Compiler::Code compiled_;
};

/// Code in which each instruction may read what any before it made, and cells with numbers to start from.
/// Calls empty the registers, so every other code has none.
TEST_CASE("compiler: random code gives the same bits as the machine that interprets it") {
  RandomStream stream(5, Purpose::kSample, 3);
  for (int round = 0; round < 40; ++round) {
    std::vector<Scalar> cells;
    std::vector<Type> types;
    for (int i = 0; i < 6; ++i) {
      cells.push_back(Scalar::of(4 * stream.uniform() - 2));
      cells.push_back(Scalar::of(static_cast<std::int64_t>(stream.below(9)) - 4));
      cells.push_back(Scalar::of(static_cast<std::int64_t>(stream.below(2))));
      types.insert(types.end(), {Type::kFloat, Type::kInt, Type::kBool});
    }
    const auto some = [&](Type type) {
      for (;;) {
        const std::size_t cell = stream.below(types.size());
        if (types[cell] == type) return static_cast<Cell>(cell);
      }
    };
    std::vector<Instruction> code;
    while (code.size() < 150) {
      const Operation& row = kOperations[stream.below(kOperations.size())];
      if (row.fold == nullptr || row.arity == 0 || has_table(row.op)) continue;
      if (round % 2 == 1 && is_called(row.op)) continue;
      Instruction step(row.op, static_cast<Cell>(cells.size()), {});
      for (std::size_t k = 0; k < row.arity; ++k)
        step.operands[k] = some(row.arity == 3 && k == 0 ? Type::kBool : row.operand);
      cells.push_back({});
      types.push_back(row.result);
      code.push_back(step);
    }
    BothMachines(code).check(cells);
    for (Instruction& step : code) step.lasts = stream.below(4) == 0;
    BothMachines(code).check(cells);
    const std::span<const Instruction> shorter(code.data(), 100);
    for (const Cell shared_end : {Cell{18}, Cell{60}, static_cast<Cell>(cells.size())})
      BothMachines(shorter, shared_end).check(cells);
  }
}

TEST_CASE("compiler: codes that are alike but for the cells that they read share a function") {
  if (!Compiler::available()) return;
  Compiler compiler;
  const auto code = [](Cell a, Cell b) {
    return std::vector{Instruction(Op::kSubFloat, 9, {a, b, 0}), Instruction(Op::kMulFloat, 10, {9, a, 0})};
  };
  const Compiler::Code first = compiler.compile(code(2, 5), 9), second = compiler.compile(code(5, 7), 9);
  const Compiler::Code square = compiler.compile(code(5, 5), 9);
  const bool alike_share = first.function == second.function, others_do = first.function == square.function;
  CHECK(alike_share);
  CHECK(!others_do);
  std::vector<Scalar> cells(11, Scalar::of(1.0));
  cells[5] = Scalar::of(3.0);
  cells[7] = Scalar::of(8.0);
  second(cells.data());
  CHECK(cells[10].f == -15);
  first(cells.data());
  CHECK(cells[10].f == -2);
  square(cells.data());
  CHECK(cells[10].f == 0);
}

TEST_CASE("machine: every operation gives what it means on constants") {
  const double floats[] = {-2.5, -1, 0, 0.5, 1, 3, 1e10};
  const std::int64_t ints[] = {-7, -1, 0, 1, 2, 9};
  const auto value = [&](Type type, std::size_t i) {
    if (type == Type::kFloat) return Scalar::of(floats[i % 7]);
    return Scalar::of(type == Type::kBool ? static_cast<std::int64_t>(i % 2) : ints[i % 6]);
  };
  for (const Operation& row : kOperations) {
    if (row.fold == nullptr || has_table(row.op)) continue;
    INFO(row.name);
    const Instruction step(row.op, 3, {0, 1, 2});
    const BothMachines both({&step, 1});
    for (std::size_t i = 0; i < 42; ++i) {
      for (std::size_t j = 0; j < 42; ++j) {
        const bool selects = row.arity == 3;
        Scalar cells[4] = {selects ? Scalar::of(static_cast<std::int64_t>(i % 2)) : value(row.operand, i),
                           value(row.operand, j),
                           value(row.operand, i / 2),
                           {}};
        const auto folded = row.fold(cells);
        both.check(cells);
        const bool made = run({&step, 1}, cells);
        if (!folded) continue;
        CHECK(made);
        CHECK(cells[3].i == folded->i);
      }
    }
  }
}

TEST_CASE("machine: pairs are looked up in a table, also those beyond it") {
  PairTable pairs(2, 3);
  pairs.allow(0, 2);
  pairs.allow(1, 0);
  const Instruction step(Op::kAllowed, 3, {0, 1, 2});
  const BothMachines both({&step, 1});
  for (std::int64_t a = -1; a <= 2; ++a) {
    for (std::int64_t b = -1; b <= 3; ++b) {
      Scalar cells[4] = {Scalar::of(a), Scalar::of(b), {.table = &pairs}, {}};
      both.check(cells);
      CHECK(run({&step, 1}, cells));
      CHECK((cells[3].i != 0) == ((a == 0 && b == 2) || (a == 1 && b == 0)));
    }
  }
}

}  // namespace
}  // namespace solitaire
