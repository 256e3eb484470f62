#include <solitaire/stop.h>

#include "library/stop_access.h"

namespace solitaire::api {
namespace {

StopReason public_reason(solitaire::StopReason reason) {
  switch (reason) {
    case solitaire::StopReason::kNone:
      return StopReason::kNone;
    case solitaire::StopReason::kInterrupt:
      return StopReason::kInterrupt;
    case solitaire::StopReason::kTime:
      return StopReason::kTime;
    case solitaire::StopReason::kTimePerSolution:
      return StopReason::kTimePerSolution;
    case solitaire::StopReason::kMemory:
      return StopReason::kMemory;
    case solitaire::StopReason::kOutOfMemory:
      break;
  }
  return StopReason::kOutOfMemory;
}

solitaire::StopReason inner_reason(StopReason reason) {
  switch (reason) {
    case StopReason::kNone:
    case StopReason::kInterrupt:
      return solitaire::StopReason::kInterrupt;
    case StopReason::kTime:
      return solitaire::StopReason::kTime;
    case StopReason::kTimePerSolution:
      return solitaire::StopReason::kTimePerSolution;
    case StopReason::kMemory:
      return solitaire::StopReason::kMemory;
    case StopReason::kOutOfMemory:
      break;
  }
  return solitaire::StopReason::kOutOfMemory;
}

}  // namespace

StopToken::StopToken() = default;
StopToken::~StopToken() = default;
StopToken::StopToken(const StopToken&) = default;
StopToken& StopToken::operator=(const StopToken&) = default;

StopReason StopToken::reason() const {
  return state_ == nullptr ? StopReason::kNone : public_reason(state_->signal.reason());
}

StopSource::StopSource() : state_(std::make_shared<StopToken::State>(nullptr)) {}
StopSource::StopSource(const StopToken& whole) : state_(std::make_shared<StopToken::State>(whole.state_)) {}
StopSource::~StopSource() = default;
StopSource::StopSource(const StopSource&) = default;
StopSource& StopSource::operator=(const StopSource&) = default;

void StopSource::request(StopReason reason) const noexcept { state_->signal.request(inner_reason(reason)); }

void StopSource::set_deadline(std::chrono::steady_clock::time_point time, StopReason reason) const {
  // A time that has come holds, whether or not anybody looked at the clock meanwhile.
  if (const auto passed = state_->signal.reason(); passed != solitaire::StopReason::kNone)
    state_->signal.request(passed);
  state_->signal.set_deadline(time, inner_reason(reason));
}

StopToken StopSource::token() const {
  StopToken token;
  token.state_ = state_;
  return token;
}

StopReason StopSource::reason() const { return token().reason(); }

const StopSignal* StopAccess::signal(const StopToken& token) {
  return token.state_ == nullptr ? nullptr : &token.state_->signal;
}

}  // namespace solitaire::api
