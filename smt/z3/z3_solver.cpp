#include "smt/z3/z3_solver.h"

#include <algorithm>
#include <climits>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <unordered_map>
#include <utility>
#include <vector>

#include "smt/z3/context.h"
#include "smt/z3/encode.h"

namespace solitaire {
namespace {

/// Interrupts Z3 once the signal says so. Z3 looks at interrupts only now and then and may miss one that
/// comes between two of its phases, so they are repeated until the check is over.
class Watchdog {
 public:
  Watchdog(z3::context& context, const StopSignal& stop)
      : thread_([this, &context, &stop] { watch(context, stop); }) {}
  ~Watchdog() {
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    wake_.notify_one();
    thread_.join();
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;

 private:
  void watch(z3::context& context, const StopSignal& stop) {
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, std::chrono::milliseconds(20), [this] { return done_; })) {
      if (stop.stopped()) context.interrupt();
    }
  }

  std::mutex mutex_;
  std::condition_variable wake_;
  bool done_ = false;
  std::thread thread_;
};

class Z3Solver : public Solver {
 public:
  Z3Solver(const Graph& graph, const AddressTable& addresses, const Z3Options& options)
      : graph_(graph),
        encoder_(context_, graph, addresses, options.fixed_width),
        solver_(options.default_solver ? z3::solver(context_) : z3::solver(context_, "QF_BV")) {
    z3::params params(context_);
    params.set("random_seed", static_cast<unsigned>(options.seed & 0x7fffffffU));
    if (options.random_phase) params.set("phase", context_.str_symbol("random"));
    params.set("ctrl_c", false);  // otherwise Z3 would take the interrupt for itself
    solver_.set(params);
  }

  void add_clause(std::span<const NodeId> conditions) override {
    Z3Context::run([&] { add(conditions); });
  }

  Verdict check(std::span<const NodeId> assumptions, const StopSignal& stop) override {
    return Z3Context::run([&] { return check_under(assumptions, stop); });
  }

  void limit_effort(std::uint64_t conflicts) override {
    effort_limited_ = conflicts > 0;
    const auto most = static_cast<unsigned>(std::min<std::uint64_t>(conflicts, UINT_MAX));
    z3::params params(context_);
    params.set("max_conflicts", effort_limited_ ? most : UINT_MAX);
    solver_.set(params);
  }

  bool suggest(std::size_t, std::int64_t) override { return false; }
  bool exact() const override { return encoder_.exact(); }

  std::int64_t value(std::size_t variable) override {
    const auto term = encoder_.choice_term(variable);
    if (!term) return graph_.variables()[variable].domain.lo;  // nothing depends on it
    return Z3Context::run(
        [&] { return encoder_.decode(variable, model_->eval(*term, true).get_numeral_uint64()); });
  }

  std::vector<NodeId> core() override {
    return Z3Context::run([&] {
      std::vector<NodeId> core;
      for (const z3::expr& literal : solver_.unsat_core()) {
        for (const auto& [id, assumption] : assumed_) {
          if (id == literal.id()) core.push_back(assumption);
        }
      }
      return core;
    });
  }

 private:
  void add(std::span<const NodeId> conditions) {
    z3::expr_vector terms(context_);
    for (const NodeId condition : conditions) terms.push_back(encoder_.condition(condition));
    add_domains();
    solver_.add(terms.empty() ? context_.bool_val(false) : z3::mk_or(terms));
  }

  Verdict check_under(std::span<const NodeId> assumptions, const StopSignal& stop) {
    z3::expr_vector terms(context_);
    assumed_.clear();
    for (const NodeId assumption : assumptions) {
      const z3::expr literal = this->literal(assumption);
      terms.push_back(literal);
      assumed_.emplace_back(literal.id(), assumption);
    }
    add_domains();
    if (stop.stopped()) return Verdict::kStopped;
    const Watchdog watchdog(context_, stop);
    switch (solver_.check(terms)) {
      case z3::sat:
        model_ = std::make_unique<z3::model>(solver_.get_model());
        return Verdict::kSatisfiable;
      case z3::unsat:
        return Verdict::kUnsatisfiable;
      case z3::unknown:
        break;
    }
    if (!stop.stopped() && !effort_limited_)
      throw std::runtime_error("Z3 gave up: " + solver_.reason_unknown());
    return Verdict::kStopped;
  }

  /// Assumptions have to be plain literals, so each condition that is assumed gets a name of its own.
  z3::expr literal(NodeId condition) {
    const auto known = literals_.find(condition);
    if (known != literals_.end()) return known->second;
    const z3::expr name = context_.bool_const(("assume!" + std::to_string(condition.index)).c_str());
    solver_.add(z3::implies(name, encoder_.condition(condition)));
    literals_.emplace(condition, name);
    return name;
  }

  void add_domains() {
    for (const z3::expr& domain : encoder_.take_domains()) solver_.add(domain);
  }

  const Graph& graph_;
  Z3Context owned_context_;
  z3::context& context_ = *owned_context_;
  Encoder encoder_;
  z3::solver solver_;
  std::unique_ptr<z3::model> model_;
  std::unordered_map<NodeId, z3::expr> literals_;
  std::vector<std::pair<unsigned, NodeId>> assumed_;
  bool effort_limited_ = false;
};

}  // namespace

std::unique_ptr<Solver> make_z3_solver(const Graph& graph, const AddressTable& addresses,
                                       const Z3Options& options) {
  return std::make_unique<Z3Solver>(graph, addresses, options);
}

}  // namespace solitaire
