#include "app/draw_printer.h"

#include <algorithm>
#include <limits>

#include "app/console.h"

namespace solitaire::app {

void DrawPrinter::print(const api::SampledDraw& draw) {
  print_result((format_ == DrawFormat::kJsonLines ? to_json(draw) : row(draw)) + "\n");
}

std::string DrawPrinter::row(const api::SampledDraw& draw) {
  if (columns_.empty()) {
    columns_ = draw.names;
    return api::csv_names(columns_) + "\n" + to_csv(draw);
  }
  if (draw.names == columns_) return to_csv(draw);
  api::SampledDraw shown{draw.chain, draw.draw, columns_, {}};
  shown.numbers.assign(columns_.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < draw.names.size(); ++i) {
    const auto at = std::find(columns_.begin(), columns_.end(), draw.names[i]);
    if (at != columns_.end()) {
      shown.numbers[static_cast<std::size_t>(at - columns_.begin())] = draw.numbers[i];
    } else if (std::find(left_out_.begin(), left_out_.end(), draw.names[i]) == left_out_.end()) {
      left_out_.push_back(draw.names[i]);
    }
  }
  return to_csv(shown);
}

}  // namespace solitaire::app
