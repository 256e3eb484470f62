#pragma once
#include <cstdint>
#include <solitaire/sample.h>
#include <string>
#include <vector>

namespace solitaire::app {

enum class DrawFormat : std::uint8_t { kJsonLines, kCsv };

/// Prints draws as they come, each on a line.
class DrawPrinter {
 public:
  explicit DrawPrinter(DrawFormat format) : format_(format) {}

  void print(const api::SampledDraw& draw);
  /// Names that the table lacks, since its columns are the names of the first draw.
  const std::vector<std::string>& left_out() const { return left_out_; }

 private:
  std::string row(const api::SampledDraw& draw);

  DrawFormat format_;
  std::vector<std::string> columns_;
  std::vector<std::string> left_out_;
};

}  // namespace solitaire::app
