#include "engines/solve/background_search.h"

namespace solitaire {
namespace {

/// Whoever takes the choices of a solution from here runs them, so a run of them here would be one too many.
TracingOptions choices_only(TracingOptions options, const StopSignal& stop) {
  options.limits.stop = &stop;
  options.scene = SceneDetail::kNone;
  options.replay = Replay::kSome;
  return options;
}

}  // namespace

BackgroundSearch::BackgroundSearch(const Program& program, ParamValues params, const TracingOptions& options,
                                   std::uint64_t first, std::vector<ChosenValues> known, std::size_t wanted)
    : program_(program),
      params_(std::move(params)),
      options_(choices_only(options, stop_)),
      whole_(options.limits.stop),
      stop_(whole_),
      first_(first),
      known_(std::move(known)),
      wanted_(wanted),
      thread_([this] { run(); }) {}

BackgroundSearch::~BackgroundSearch() {
  stop_.request();
  changed_.notify_all();
}

void BackgroundSearch::run() {
  try {
    TracingEngine engine(program_, std::move(params_), options_, first_);
    for (const ChosenValues& known : known_) engine.exclude(known);
    while (wait_until_wanted()) {
      const std::optional<Solution> solution = engine.next();
      std::unique_lock lock(mutex_);
      times_ = engine.times();
      times_.replays = 0;  // whoever takes the solution runs it again, and counts that
      if (!solution) {
        lock.unlock();
        return finish({engine.ending(), nullptr});
      }
      found_.push_back(all_choices(*solution));
      changed_.notify_all();
    }
    finish({Ending::kStopped, nullptr});
  } catch (const Interrupted&) {
    finish({Ending::kStopped, nullptr});
  } catch (...) {
    finish({Ending::kStopped, std::current_exception()});
  }
}

void BackgroundSearch::finish(End end) {
  const std::lock_guard lock(mutex_);
  end_ = std::move(end);
  changed_.notify_all();
}

/// Signals wake nobody, so they are looked at now and then.
constexpr std::chrono::milliseconds kLook{20};

EngineTimes BackgroundSearch::times() const {
  const std::lock_guard lock(mutex_);
  return times_;
}

bool BackgroundSearch::wait_until_wanted() {
  std::unique_lock lock(mutex_);
  while (taken_ + found_.size() >= wanted_ && !stop_.stopped()) changed_.wait_for(lock, kLook);
  return !stop_.stopped();
}

std::optional<ChosenValues> BackgroundSearch::next() {
  std::unique_lock lock(mutex_);
  wanted_ = std::max(wanted_, taken_ + 1);
  changed_.notify_all();
  while (found_.empty() && !end_) {
    if (whole_ != nullptr && whole_->stopped()) {
      ending_ = Ending::kStopped;
      return std::nullopt;
    }
    changed_.wait_for(lock, kLook);
  }
  if (found_.empty()) {
    if (end_->error) std::rethrow_exception(end_->error);
    ending_ = end_->ending;
    return std::nullopt;
  }
  ChosenValues next = std::move(found_.front());
  found_.pop_front();
  ++taken_;
  return next;
}

}  // namespace solitaire
