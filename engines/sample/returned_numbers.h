#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "solitaire/names/program.h"
#include "solitaire/value/plain_value.h"

namespace solitaire {

/// Finds the numbers in what a program returns and names them: after the expressions that it returns, such as
/// "slope" and "1 / sqrt(tau)", with the way to parts of lists and records behind them, as in "topics[0][2]".
/// What cannot be said shortly, or was said of another one, is a part of "value". A bool counts as 0 or 1;
/// texts are left out.
class ReturnedNumbers {
 public:
  explicit ReturnedNumbers(const Program& program);

  /// Adds the numbers of a value to both lists, in the same order.
  void read(const PlainValue& value, std::vector<std::string>& names, std::vector<double>& numbers) const;

 private:
  std::vector<std::string> items_;  // of the list that is returned, if its expressions stand in the text
  std::string whole_ = "value";
};

}  // namespace solitaire
