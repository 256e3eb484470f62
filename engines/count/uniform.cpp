#include "engines/count/uniform.h"

#include <algorithm>
#include <cmath>

#include "engines/errors.h"

namespace solitaire {
namespace {

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  return b != 0 && a > UINT64_MAX / b ? UINT64_MAX : a * b;
}

}  // namespace

UniformEngine::UniformEngine(const Program& program, ParamValues params, const TracingOptions& options,
                             const UniformOptions& uniform)
    : seed_(options.seed),
      stop_(options.limits.stop),
      uniform_(uniform),
      program_(program, std::move(params), options) {}

void UniformEngine::explore() {
  if (space_ || ending_ != Ending::kNone) return;
  if (!program_.explore_fully()) {
    ending_ = Ending::kUnexplored;
    return;
  }
  if (!program_.trace().soft_terms.empty()) {
    throw UnequalSolutions(
        "a program that prefers some of its solutions cannot be sampled uniformly: it has prefer, minimize "
        "or "
        "maximize");
  }
  space_.emplace(program_);
}

/// Lists what is not much, and prepares to draw the rest.
void UniformEngine::prepare() {
  explore();
  if (prepared_ || ending_ != Ending::kNone) return;
  std::vector<std::size_t> large;
  std::vector<std::vector<BitModel>> listed;
  total_ = 1;
  for (std::size_t i = 0; i < space_->parts().size(); ++i) {
    SpacePart& part = space_->parts()[i];
    if (const auto values = part.free_values()) {
      total_ = product(total_, *values);
      listed.emplace_back();
      continue;
    }
    std::vector<BitModel> models = part.find({}, uniform_.most_listed + 1, stop_);
    if (models.size() > uniform_.most_listed) {
      large.push_back(i);
    } else {
      total_ = product(total_, models.size());
      listed.push_back(std::move(models));
    }
  }
  if (!large.empty() && total_ > 0) {
    space_->join(large);
    SpacePart& rest = space_->parts().back();
    nested_ = rest.nested_sampler(RandomStream(seed_, Purpose::kCells, 1), stop_);
    if (!nested_) cells_.emplace(rest, RandomStream(seed_, Purpose::kCells, 0), stop_);
  }
  listed_ = std::move(listed);
  prepared_ = true;
}

/// Returns true if so many solutions came, or were drawn in vain, that listing all of them is no more work.
/// This does not depend on anything that is not known to a run that goes on after the same solutions.
bool UniformEngine::worth_listing() const {
  const double guessed = nested_ ? nested_->guessed_solutions() : cells_->guessed_models();
  const double quarter = guessed * static_cast<double>(total_) / 4;
  return static_cast<double>(came_) > quarter ||
         static_cast<double>(draws_) > std::max(tuning::kFewDraws, quarter);
}

bool UniformEngine::all_drawn() const {
  if (has_rest() && !rest_) return false;
  return drawn_.size() >= (rest_ ? product(total_, rest_->size()) : total_);
}

void UniformEngine::draw_rest(VariableValues& values) {
  SpacePart& rest = space_->parts().back();
  if (worth_listing()) {
    if (!rest_) rest_ = rest.find({}, SIZE_MAX, stop_);
    rest.decode((*rest_)[random_->below(rest_->size())], values);
  } else if (nested_) {
    nested_->clusters().decode(nested_->draw(*random_, stop_), values);
  } else {
    rest.decode(cells_->draw(*random_, stop_), values);
  }
}

VariableValues UniformEngine::draw() {
  ++draws_;
  VariableValues values = space_->lowest();
  for (std::size_t i = 0; i < listed_.size(); ++i) {
    const SpacePart& part = space_->parts()[i];
    if (const auto count = part.free_values()) {
      values[part.variables().front()] = part.free_value(random_->below(*count));
    } else {
      part.decode(listed_[i][random_->below(listed_[i].size())], values);
    }
  }
  if (has_rest()) draw_rest(values);
  return values;
}

std::optional<Solution> UniformEngine::next() {
  if (ending_ != Ending::kNone) return std::nullopt;
  try {
    prepare();
    if (ending_ != Ending::kNone) return std::nullopt;
    if (!passed_over_) {
      random_.emplace(seed_, Purpose::kSample, came_++);
      draws_ = 0;
    }
    passed_over_ = false;
    while (!all_drawn()) {
      const VariableValues values = draw();
      if (!drawn_.insert(values).second) continue;
      Assignment assignment = completed(values);
      return program_.solution(program_.execution(assignment));
    }
    ending_ = Ending::kExhausted;
  } catch (const Interrupted&) {
    ending_ = Ending::kStopped;
  }
  return std::nullopt;
}

/// The values, which outlive it, with those of auxiliary choices that fit them.
Assignment UniformEngine::completed(const VariableValues& values) {
  Graph& graph = program_.graph();
  if (space_->auxiliary().empty())
    return {graph, [&values](std::size_t variable) { return Scalar::of(values[variable]); }};
  const auto outcome = program_.solver().find([&] {
    std::vector<NodeId> equal;
    for (std::size_t variable = 0; variable < values.size(); ++variable) {
      if (space_->auxiliary().count(variable) != 0) continue;
      equal.push_back(
          graph.apply(Op::kEqInt, {graph.variable_node(variable), graph.constant(values[variable])}));
    }
    return equal;
  });
  if (outcome == ExecutionSolver::Outcome::kStopped) throw Interrupted{};
  if (outcome != ExecutionSolver::Outcome::kFound) throw InternalError("no auxiliary choices fit a sample");
  return program_.solver().assignment();
}

void UniformEngine::exclude(const ChosenValues& choices) {
  explore();
  if (!space_) return;
  drawn_.insert(space_->values_of(choices));
  ++came_;
}

}  // namespace solitaire
