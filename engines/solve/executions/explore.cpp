#include "engines/solve/executions/explore.h"

#include <algorithm>
#include <unordered_map>

#include "base/hash.h"
#include "engines/random_choices.h"

namespace solitaire {

class Explorer::OpenSides : public Branches {
 public:
  struct SideHash {
    std::size_t operator()(const BranchSide& side) const {
      return mix(side.branch.index, static_cast<std::uint64_t>(side.kind));
    }
  };

  std::uint32_t levels = 0;                                        // the levels with which a pass starts
  std::size_t unasked = 0;                                         // how many more may be opened by level
  std::unordered_map<BranchSide, std::uint32_t, SideHash> opened;  // and the levels below each

  std::optional<std::uint32_t> open(const BranchSide& side, std::uint32_t left) override {
    const std::uint32_t below = left > 0 ? left - 1 : 0;
    if (const auto it = opened.find(side); it != opened.end()) return std::max(it->second, below);
    if (left == 0 || unasked == 0) return std::nullopt;
    --unasked;
    opened.emplace(side, 0);
    return below;
  }

  void taken(const BranchSide& side) override { opened.try_emplace(side, 0); }
};

Explorer::Explorer(const Program& program, ParamValues params, const Exploration& exploration,
                   std::uint64_t seed, const Limits& limits, Choices& choices, Graph& graph,
                   AddressTable& addresses)
    : program_(program),
      params_(std::move(params)),
      exploration_(exploration),
      seed_(seed),
      limits_(limits),
      granted_(limits),
      choices_(choices),
      graph_(graph),
      addresses_(addresses),
      sides_(std::make_unique<OpenSides>()),
      grant_(exploration.grant) {
  sides_->unasked = exploration.unasked_sides;
  granted_.fuel_steps = std::min(exploration.fuel_steps, limits.max_steps);
  granted_.fuel_depth = std::min(exploration.fuel_depth, limits.max_depth);
}

Explorer::~Explorer() = default;

void Explorer::run_pass() {
  pass_ = trace(program_, params_, choices_, *sides_, sides_->levels, graph_, addresses_, granted_);
  ++passes_;
}

void Explorer::start() {
  if (exploration_.policy == Exploration::Policy::kRandom) {
    open_random_sides();
    granted_.fuel_steps = limits_.max_steps;
    granted_.fuel_depth = limits_.max_depth;
    return run_pass();
  }
  for (std::uint32_t levels = exploration_.levels; levels <= tuning::kMostLevels;
       levels *= tuning::kLevelGrowth) {
    sides_->levels = levels;
    run_pass();
    if (pass_.trace.blockers.empty() || sides_->unasked == 0) return;
    const auto is_cut = [](const TraceBlocker& blocker) {
      return blocker.side.kind == BranchSide::Kind::kCut;
    };
    if (std::all_of(pass_.trace.blockers.begin(), pass_.trace.blockers.end(), is_cut)) return;
  }
}

void Explorer::open_random_sides() {
  Limits limits = limits_;
  limits.keep_going = true;
  Executor executor(program_, params_, addresses_, limits, sides_.get());
  for (std::uint64_t i = 0; i < exploration_.executions; ++i) {
    RandomChoices choices(RandomStream(seed_, Purpose::kExplore, i));
    try {
      executor.run(choices);
    } catch (const ProgramError&) {
      // The sides up to the error are open now. The solver decides whether it can be reached.
    }
  }
}

void Explorer::count_least_steps() {
  limits_.least_steps = granted_.least_steps = true;
  run_pass();
}

bool Explorer::open(const std::vector<std::size_t>& blockers) {
  if (exploration_.policy == Exploration::Policy::kRandom) return false;
  bool cut = false;
  bool closed = false;
  for (const std::size_t number : blockers) {
    const BranchSide& side = pass_.trace.blockers[number].side;
    if (side.kind == BranchSide::Kind::kCut) {
      cut = true;
      continue;
    }
    closed = true;
    std::uint32_t& levels = sides_->opened[side];
    levels = std::max(levels, grant_);
  }
  if (cut) {
    granted_.fuel_steps = std::min(granted_.fuel_steps * tuning::kFuelGrowth, limits_.max_steps);
    granted_.fuel_depth = static_cast<std::uint32_t>(
        std::min<std::uint64_t>(std::uint64_t{granted_.fuel_depth} * tuning::kFuelGrowth, limits_.max_depth));
    if (granted_.fuel_steps == limits_.max_steps) granted_.fuel_steps = UINT64_MAX;
    if (granted_.fuel_depth == limits_.max_depth) granted_.fuel_depth = UINT32_MAX;
  }
  if (closed) {
    grant_ = std::min(grant_ * 2, tuning::kMostLevels);
    sides_->unasked = exploration_.unasked_sides;
  }
  run_pass();
  return true;
}

}  // namespace solitaire
