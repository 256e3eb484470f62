#include "smt/sat/cadical.h"

#include <algorithm>
#include <cadical.hpp>
#include <climits>
#include <utility>

#include "smt/tuning.h"

namespace solitaire {
namespace {

/// Ends a search of CaDiCaL once the signal says so. CaDiCaL asks very often, so the clock is looked at only
/// now and then.
class Stop : public CaDiCaL::Terminator {
 public:
  explicit Stop(const StopSignal& signal) : signal_(signal) {}

  bool terminate() override {
    if (calls_++ % tuning::kCadicalQuestionsPerLook == 0 && signal_.stopped()) stopped_ = true;
    return stopped_;
  }

 private:
  const StopSignal& signal_;
  unsigned calls_ = 0;
  bool stopped_ = false;
};

/// Writes clauses straight into CaDiCaL.
class Direct : public ClauseSink {
 public:
  explicit Direct(CaDiCaL::Solver& solver) : solver_(solver) {}

  void clause(std::span<const int> literals) override {
    for (const int literal : literals) solver_.add(literal);
    solver_.add(0);
  }

 private:
  CaDiCaL::Solver& solver_;
};

/// Translates what CaDiCaL's solve() returns.
Verdict verdict_of(int status) {
  constexpr int kSatisfied = 10;
  constexpr int kUnsatisfied = 20;
  if (status == kSatisfied) return Verdict::kSatisfiable;
  return status == kUnsatisfied ? Verdict::kUnsatisfiable : Verdict::kStopped;
}

}  // namespace

Cadical::Cadical(Use use, std::uint64_t seed) : use_(use), seed_(seed) {
  untold_.reserve(tuning::kUsualLiterals);
  untold_implications_.reserve(tuning::kUsualLiterals / 16);
}

Cadical::~Cadical() = default;

void Cadical::clause(std::span<const int> literals) {
  untold_.insert(untold_.end(), literals.begin(), literals.end());
  untold_.push_back(0);
}

void Cadical::order_implication(const OrderImplication& order_implication) {
  untold_implications_.push_back(order_implication);
}

void Cadical::order_difference(const OrderDifference& difference) {
  untold_differences_.push_back(difference);
}

void Cadical::set_up() {
  constexpr std::uint64_t kSeeds = 2'000'000'000;  // CaDiCaL takes smaller ones only
  solver_ = std::make_unique<CaDiCaL::Solver>();
  solver_->set("quiet", 1);
  solver_->set("seed", static_cast<int>(seed_ % kSeeds));
  // Lucky phases are tried before the search, for each model anew. They would find the same one whatever the
  // seed and the preferred literals are.
  solver_->set("lucky", 0);
  // Models are found sooner where the search hardly ever restarts; proofs are not.
  solver_->set("stabilizeonly", use_ == Use::kRefutation ? 0 : 1);
  solver_->set("phase", phase_ ? 1 : 0);
  if (use_ == Use::kProof) return;
  // With target phases, CaDiCaL searches around the assignment that came furthest, so around the last model.
  solver_->set("target", 0);
  solver_->set("elimint", tuning::kEliminationInterval);
  solver_->set("probeint", tuning::kProbingInterval);
  solver_->set("subsumeint", tuning::kSubsumptionInterval);
  solver_->set("reduceint", tuning::kReductionInterval);
}

void Cadical::tell() {
  if (solver_ == nullptr) set_up();
  for (const int literal : untold_) solver_->add(literal);
  Direct sink(*solver_);
  for (const OrderImplication& order_implication : untold_implications_)
    sink.order_implication(order_implication);
  for (const OrderDifference& difference : untold_differences_) sink.order_difference(difference);
  untold_.clear();
  untold_implications_.clear();
  untold_differences_.clear();
}

void Cadical::prefer(std::vector<int> literals) {
  tell();  // CaDiCaL has to know the variables
  preferred_ = std::move(literals);
  for (const int literal : preferred_) solver_->phase(literal);
}

void Cadical::prefer_nothing() {
  for (const int literal : std::exchange(preferred_, {})) solver_->unphase(literal);
}

Verdict Cadical::solve(std::span<const int> assumptions, const StopSignal& signal, std::uint64_t conflicts) {
  tell();
  if (signal.stopped()) return Verdict::kStopped;
  for (const int literal : assumptions) solver_->assume(literal);
  if (conflicts > 0) {  // the limit is one of the next call of solve() alone
    solver_->limit("conflicts", static_cast<int>(std::min<std::uint64_t>(conflicts, INT_MAX)));
  }
  Stop stop(signal);
  solver_->connect_terminator(&stop);
  const Verdict verdict = verdict_of(solver_->solve());
  solver_->disconnect_terminator();
  return verdict;
}

void Cadical::start_anew(std::uint64_t seed, bool phase) {
  tell();
  seed_ = seed;
  phase_ = phase;
  const std::unique_ptr<CaDiCaL::Solver> old = std::move(solver_);
  set_up();
  old->copy(*solver_);
}

void Cadical::use_for(Use use) {
  if (std::exchange(use_, use) != use && solver_ != nullptr) start_anew(seed_, phase_);
}

bool Cadical::holds(int variable) const { return solver_->val(variable) > 0; }

std::vector<NodeId> Cadical::core(std::span<const NodeId> conditions, std::span<const int> assumed) {
  std::vector<NodeId> core;
  for (std::size_t i = 0; i < assumed.size(); ++i) {
    if (solver_->failed(assumed[i])) core.push_back(conditions[i]);
  }
  return core;
}

}  // namespace solitaire
