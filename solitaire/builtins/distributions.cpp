#include "solitaire/builtins/distributions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <fmt/format.h>

#include "solitaire/builtins/prior.h"
#include "solitaire/value/plain_value.h"

namespace solitaire {
namespace {

using Call = const BuiltinCall&;
using Items = std::span<const Value>;
using Family = Distribution::Family;

struct RecordKind : RecordStmt {
  RecordKind(const char* called, const std::vector<const char*>& names) : RecordStmt(Span{}) {
    name = called;
    for (const char* each : names) fields.push_back({each, {}, nullptr});
  }
};

/// The kinds of records that distributions are: first those of distribution_rows(), in their order.
struct RecordKinds {
  std::deque<RecordKind> of_rows;
  RecordKind categorical{"Categorical", {"weights"}};
  RecordKind dirichlet{"Dirichlet", {"concentrations"}};

  RecordKinds() {
    for (const DistributionRow& row : distribution_rows()) {
      std::vector<const char*> names;
      for (const ParameterRow& parameter : row.parameters) names.push_back(parameter.name);
      of_rows.emplace_back(row.record, names);
    }
  }
};

const RecordKinds& record_kinds() {
  static const RecordKinds kinds;
  return kinds;
}

// ---- draws

Value decide_flip(Evaluator& evaluator, const CallExpr& site, const Prior& prior) {
  const Value side = evaluator.decide(site, std::int64_t{0}, std::int64_t{1}, std::int64_t{1}, prior);
  return evaluator.equal(side, std::int64_t{1});
}

/// A solver looks at what is possible, so the probability is nothing to it as long as it is one.
Value flip(Evaluator& evaluator, Call call) {
  const Value& probability = call.arguments[0];
  if (!given(probability)) return decide_flip(evaluator, call.site, {Distribution::flip(), {Value(0.5)}});
  if (is_known(probability) || evaluator.weighs()) {
    const Prior prior = prior_of(evaluator, distribution_row(Family::kFlip), call.arguments, call.site, true);
    return decide_flip(evaluator, call.site, prior);
  }
  evaluator.effects().needs_execution();  // which looks at whether it is a probability
  return decide_flip(evaluator, call.site, {Distribution::flip(), {Value(0.5)}});
}

template <Family kFamily>
Value draw(Evaluator& evaluator, Call call) {
  const DistributionRow& row = distribution_row(kFamily);
  return evaluator.draw(call.site, prior_of(evaluator, row, call.arguments, call.site, true), row.draw);
}

/// The family of a normal distribution and its two parameters, of three of which the last exclude each other.
std::pair<Family, std::array<Value, 2>> normal_parameters(Evaluator& evaluator, Call call) {
  const Value& sd = call.arguments[1];
  const Value& precision = call.arguments[2];
  if (given(sd) == given(precision)) {
    evaluator.program_error(call.site.span,
                            "a normal distribution has a mean and either an sd or a precision",
                            "normal(0, 10) or normal(0, precision: 0.01)");
  }
  if (given(sd)) return {Family::kNormal, {call.arguments[0], sd}};
  return {Family::kNormalSharp, {call.arguments[0], precision}};
}

Value normal(Evaluator& evaluator, Call call) {
  const auto [family, parameters] = normal_parameters(evaluator, call);
  return evaluator.draw(call.site, prior_of(evaluator, distribution_row(family), parameters, call.site, true),
                        "normal");
}

/// An int from 0 up to the last of the weights, which are looked at where that matters.
Value decide_weighted(Evaluator& evaluator, Call call, const Value& last, const Value& weights,
                      const char* of) {
  const std::int64_t zero = 0;
  const std::int64_t one = 1;
  if (!evaluator.weighs()) return evaluator.decide(call.site, zero, last, one, {Distribution::index(1), {}});
  return evaluator.with_items(weights, of, call.site.span, [&](Items items) {
    return evaluator.decide(call.site, zero, last, one, weighted_prior(evaluator, items, of, call.site.span));
  });
}

Value last_index(Evaluator& evaluator, const Value& list, const char* of, Span span) {
  return evaluator.with_items(list, of, span,
                              [](Items items) { return Value(static_cast<std::int64_t>(items.size()) - 1); });
}

Value categorical(Evaluator& evaluator, Call call) {
  evaluator.effects().choosing_from(Value::nil());
  const Value last = last_index(evaluator, call.arguments[0], "categorical", call.site.span);
  return decide_weighted(evaluator, call, last, call.arguments[0], "categorical");
}

Value choose(Evaluator& evaluator, Call call) {
  const Value& list = call.arguments[0];
  const Value& weights = call.arguments[1];
  const Span span = call.site.span;
  // One choice for all lengths that the list can have, so that it is the same choice whatever they are.
  const auto& given_list = call.site.arguments.front();
  const Value last =
      last_index(evaluator, list, "choose", given_list.name.empty() ? given_list.value->span : span);
  evaluator.effects().choosing_from(list);
  if (!given(weights)) {
    const Value index =
        evaluator.decide(call.site, std::int64_t{0}, last, std::int64_t{1}, {Distribution::index(1), {}});
    return evaluator.element(list, index, span);
  }
  evaluator.program_error_if(
      evaluator.invert(evaluator.equal(last, last_index(evaluator, weights, "choose", span))), span,
      "'choose' needs as many weights as the list has elements");
  return evaluator.element(list, decide_weighted(evaluator, call, last, weights, "choose"), span);
}

/// Sums of the concentrations from each of them on.
std::vector<Value> tail_sums(Evaluator& evaluator, Items items, Span span) {
  std::vector<Value> sums(items.begin(), items.end());
  for (std::size_t i = items.size() - 1; i-- > 0;)
    sums[i] = evaluator.arithmetic(BinaryOp::kAdd, items[i], sums[i + 1], span);
  return sums;
}

/// Throws where a parameter of a Dirichlet distribution can be none.
void check_concentrations(Evaluator& evaluator, Items items, const char* of, Span span) {
  if (items.empty())
    evaluator.program_error(span, fmt::format("'{}' needs a list of positive numbers, not an empty one", of));
  for (const Value& item : items) {
    const double known = known_number(evaluator, item, of, span);
    if (known > 0) continue;
    evaluator.program_error(
        span, fmt::format("the concentrations of '{}' are positive numbers, not {}", of, float_text(known)));
  }
}

/// A point of a simplex, by breaking a stick: the first part of what is left has a beta distribution
/// (Ferguson 1973; Gelman and others, Bayesian Data Analysis, appendix A). So it is several choices, one
/// fewer than there are parts, and each of them alone has a beta distribution given counts.
Value dirichlet(Evaluator& evaluator, Call call) {
  const Span span = call.site.span;
  return evaluator.with_items(call.arguments[0], "dirichlet", span, [&](Items items) {
    check_concentrations(evaluator, items, "dirichlet", span);
    const std::vector<Value> sums = tail_sums(evaluator, items, span);
    std::vector<Value> parts;
    Value left = 1.0;
    for (std::size_t i = 0; i + 1 < items.size(); ++i) {
      const std::array<Value, 2> shapes = {items[i], sums[i + 1]};
      const Prior prior = prior_of(evaluator, distribution_row(Family::kBeta), shapes, call.site, false);
      const Value share = evaluator.draw(call.site, prior, "dirichlet", static_cast<std::uint32_t>(i));
      const Value others = evaluator.arithmetic(BinaryOp::kSubtract, 1.0, share, span);
      parts.push_back(i == 0 ? share : evaluator.arithmetic(BinaryOp::kMultiply, left, share, span));
      left = i == 0 ? others : evaluator.arithmetic(BinaryOp::kMultiply, left, others, span);
    }
    parts.push_back(left);
    return evaluator.make_list(std::move(parts), span);
  });
}

// ---- distributions as values

template <Family kFamily>
Value distribution(Evaluator& evaluator, Call call) {
  const DistributionRow& row = distribution_row(kFamily);
  const RecordStmt& kind =
      record_kinds().of_rows[static_cast<std::size_t>(&row - distribution_rows().data())];
  return evaluator.make_record(&kind, {call.arguments.begin(), call.arguments.end()}, call.site.span);
}

Value normal_distribution(Evaluator& evaluator, Call call) {
  const auto [family, parameters] = normal_parameters(evaluator, call);
  const RecordStmt& kind =
      record_kinds()
          .of_rows[static_cast<std::size_t>(&distribution_row(family) - distribution_rows().data())];
  return evaluator.make_record(&kind, {parameters[0], parameters[1]}, call.site.span);
}

Value categorical_distribution(Evaluator& evaluator, Call call) {
  return evaluator.make_record(&record_kinds().categorical, {call.arguments[0]}, call.site.span);
}

Value dirichlet_distribution(Evaluator& evaluator, Call call) {
  return evaluator.make_record(&record_kinds().dirichlet, {call.arguments[0]}, call.site.span);
}

/// The density of a Dirichlet distribution at a list of numbers above 0.
Value dirichlet_density(Evaluator& evaluator, Items items, Items x, Span span) {
  if (items.size() != x.size())
    evaluator.program_error(span, "a Dirichlet distribution and its value have as many parts");
  check_concentrations(evaluator, items, "Dirichlet", span);
  const auto combine = [&](BinaryOp op, const Value& a, const Value& b) {
    return evaluator.arithmetic(op, a, b, span);
  };
  const auto log_gamma = [&](const Value& of) {
    return evaluator.unary(Op::kLgamma, evaluator.to_float(of, span), span);
  };
  Value density = log_gamma(tail_sums(evaluator, items, span).front());
  for (std::size_t i = 0; i < items.size(); ++i) {
    known_number(evaluator, x[i], "Dirichlet", span);
    const Value power = combine(BinaryOp::kSubtract, items[i], 1.0);
    const Value log_part = evaluator.unary(Op::kLog, evaluator.to_float(x[i], span), span);
    density = combine(BinaryOp::kAdd, density, combine(BinaryOp::kMultiply, power, log_part));
    density = combine(BinaryOp::kSubtract, density, log_gamma(items[i]));
  }
  return density;
}

Value density_at(Evaluator& evaluator, const Record& record, const Prior& prior, const Value& x, Span span) {
  const Type type = prior.distribution.type();
  const bool fits = type == Type::kFloat ? x.is_number() : x.has_type(type);
  if (!fits) {
    evaluator.program_error(span,
                            fmt::format("a value of {} is {}, not {}", record.type->name,
                                        type == Type::kFloat ? "a number" : in_words(type), describe(x)));
  }
  if (!is_known(x)) evaluator.unsupported(span, "no solver looks at densities", "'solitaire sample' does");
  return evaluator.log_density(prior, x, span);
}

Value density_of_record(Evaluator& evaluator, const Record& record, const Value& x, const CallExpr& site) {
  const Span span = site.span;
  const RecordKinds& kinds = record_kinds();
  for (std::size_t i = 0; i < kinds.of_rows.size(); ++i) {
    if (record.type == &kinds.of_rows[i])
      return density_at(evaluator, record,
                        prior_of(evaluator, distribution_rows()[i], record.fields, site, false), x, span);
  }
  return evaluator.with_items(record.fields[0], record.type->name.c_str(), span, [&](Items items) -> Value {
    if (record.type == &kinds.categorical)
      return density_at(evaluator, record, weighted_prior(evaluator, items, "Categorical", span), x, span);
    return evaluator.with_items(
        x, "Dirichlet", span, [&](Items parts) { return dirichlet_density(evaluator, items, parts, span); });
  });
}

bool is_distribution(const RecordStmt* type) {
  const RecordKinds& kinds = record_kinds();
  return type == &kinds.categorical || type == &kinds.dirichlet ||
         std::any_of(kinds.of_rows.begin(), kinds.of_rows.end(),
                     [=](const RecordKind& each) { return &each == type; });
}

Value log_density(Evaluator& evaluator, Call call) {
  const Span span = call.site.span;
  return evaluator.each_shape(call.arguments[0], [&](const Value& given) {
    const Record* record = given.object<Record>();
    if (record == nullptr || !is_distribution(record->type)) {
      evaluator.program_error(span, fmt::format("this needs a distribution, not {}", describe(given)),
                              "such as Normal(0, 1), with a capital letter: normal(0, 1) is a choice");
    }
    return evaluator.each_shape(call.arguments[1], [&](const Value& x) {
      return density_of_record(evaluator, *record, x, call.site);
    });
  });
}

// ---- weights of executions

Value observe(Evaluator& evaluator, Call call) {
  if (!evaluator.weighs()) evaluator.factor(call.site, 0.0, "observe");  // which says that this cannot be
  evaluator.factor(call.site, log_density(evaluator, call), "observe");
  return Value::nil();
}

Value factor(Evaluator& evaluator, Call call) {
  if (!call.arguments[0].is_number() && call.arguments[0].as_union() == nullptr) {
    evaluator.program_error(call.site.span,
                            fmt::format("'factor' needs a number, not {}", describe(call.arguments[0])));
  }
  evaluator.factor(call.site, call.arguments[0], "factor");
  return Value::nil();
}

}  // namespace

std::vector<Builtin> distribution_builtins() {
  constexpr bool kChoice = true;
  return {
      {"flip", {"probability"}, 0, false, false, kChoice, flip},
      {"choose", {"list", "weights"}, 1, false, false, kChoice, choose},
      {"categorical", {"weights"}, 1, false, false, kChoice, categorical},
      {"uniform", {"lo", "hi"}, 2, false, false, kChoice, draw<Family::kUniform>},
      {"normal", {"mean", "sd", "precision"}, 1, false, false, kChoice, normal},
      {"exponential", {"rate"}, 1, false, false, kChoice, draw<Family::kExponential>},
      {"gamma", {"shape", "rate"}, 2, false, false, kChoice, draw<Family::kGamma>},
      {"beta", {"a", "b"}, 2, false, false, kChoice, draw<Family::kBeta>},
      {"poisson", {"rate"}, 1, false, false, kChoice, draw<Family::kPoisson>},
      {"geometric", {"probability"}, 1, false, false, kChoice, draw<Family::kGeometric>},
      {"dirichlet", {"concentrations"}, 1, false, false, kChoice, dirichlet},
      {"Flip", {"probability"}, 1, false, false, false, distribution<Family::kFlip>},
      {"Categorical", {"weights"}, 1, false, false, false, categorical_distribution},
      {"Uniform", {"lo", "hi"}, 2, false, false, false, distribution<Family::kUniform>},
      {"Normal", {"mean", "sd", "precision"}, 1, false, false, false, normal_distribution},
      {"Exponential", {"rate"}, 1, false, false, false, distribution<Family::kExponential>},
      {"Gamma", {"shape", "rate"}, 2, false, false, false, distribution<Family::kGamma>},
      {"Beta", {"a", "b"}, 2, false, false, false, distribution<Family::kBeta>},
      {"Poisson", {"rate"}, 1, false, false, false, distribution<Family::kPoisson>},
      {"Geometric", {"probability"}, 1, false, false, false, distribution<Family::kGeometric>},
      {"Dirichlet", {"concentrations"}, 1, false, false, false, dirichlet_distribution},
      {"observe", {"distribution", "value"}, 2, false, false, false, observe},
      {"factor", {"log_weight"}, 1, false, false, false, factor},
      {"log_density", {"distribution", "value"}, 2, false, false, false, log_density},
  };
}

}  // namespace solitaire
