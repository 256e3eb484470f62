#pragma once
#include <fmt/format.h>
#include <string>

namespace solitaire::tiles::bench {

/// Prints lines of a figure: what the paper says, what was measured here, and whether what must hold does.
class Report {
 public:
  void figure(const std::string& title, const std::string& paper) {
    fmt::print("\n{}\n  paper: {}\n", title, paper);
    std::fflush(stdout);
  }
  void line(const std::string& text) {
    fmt::print("  ours:  {}\n", text);
    std::fflush(stdout);
  }
  void must(const std::string& what, bool holds) {
    fmt::print("  {}: {}\n", holds ? "pass" : "FAIL", what);
    failures_ += holds ? 0 : 1;
  }
  int failures() const { return failures_; }

 private:
  int failures_ = 0;
};

}  // namespace solitaire::tiles::bench
