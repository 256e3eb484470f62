#include "app/signals.h"

#include <csignal>

namespace solitaire::app {
namespace {

void request_stop(int) { stop_source().request(); }

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

const StopSource& stop_source() {
  static const StopSource source;
  return source;
}

void catch_signals() {
  stop_source();  // a handler must not be the first to construct it
  constexpr int kOnce = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM}) handle(signal, request_stop, kOnce);
  for (const int signal : {SIGPIPE, SIGXFSZ}) handle(signal, SIG_IGN, 0);
}

}  // namespace solitaire::app
