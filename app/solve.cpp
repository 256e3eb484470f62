#include <fmt/format.h>

#include "app/commands.h"
#include "app/search.h"
#include "app/solution_json.h"

namespace solitaire {
namespace {

void print_json(std::uint64_t number, const Solution& solution, const AddressTable& addresses) {
  nlohmann::ordered_json line{{"index", number}};
  line.update(solution_json(solution, addresses));
  fmt::print("{}\n", json_text(line));
}

void print_text(std::uint64_t number, const Solution& solution, const AddressTable& addresses) {
  fmt::print("solution {}: {}\n", number, to_text(solution.execution.value));
  for (const AnsweredChoice& choice : readable(solution.choices, addresses)) {
    if (choice.kind == ChoiceKind::kBool) {
      fmt::print("  {} = {}\n", choice.address, choice.value != 0);
    } else {
      fmt::print("  {} = {}\n", choice.address, choice.value);
    }
  }
}

}  // namespace

ExitStatus solve(const Options& options) {
  const Session session(options);
  Search search(session, options);
  const auto print = options.json ? print_json : print_text;
  const ExitStatus status = search.run([&](std::uint64_t number, const Solution& solution) {
    print(number, solution, search.engine().addresses());
    if (std::fflush(stdout) != 0) throw FileError("standard output", "cannot be written to");
  });
  return status;
}

}  // namespace solitaire
