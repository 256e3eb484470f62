#include "smt/write_dimacs.h"

#include <fmt/format.h>

#include "smt/sat/bit_blast.h"

namespace solitaire {
namespace {

constexpr const char* kHeader =
    "c A formula of solitaire: what holds in the solutions that are left. It depends on these choices:\n"
    "c     choice ADDRESS = LOWEST..HIGHEST step STEP: BITS\n"
    "c with the least significant bit first, each a literal, T or F where it is known. They count the steps\n"
    "c from LOWEST to the choice; where STEP is 1, they are the choice itself, in two's complement if "
    "LOWEST\n"
    "c is negative.\n"
    "c\n";

class Text : public ClauseSink {
 public:
  void clause(std::span<const int> literals) override {
    for (const int literal : literals) {
      fmt::format_to(std::back_inserter(clauses_), "{} ", literal);
    }
    clauses_ += "0\n";
    ++count_;
  }

  /// Returns the line that the format requires behind the comments.
  std::string problem(int variables) const {
    return fmt::format("p cnf {} {}\n{}", variables, count_, clauses_);
  }

 private:
  std::string clauses_;
  std::size_t count_ = 0;
};

std::string bit_text(Literal bit, Cnf& cnf) {
  if (is_constant(bit)) return bit == kTrueLiteral ? " T" : " F";
  return fmt::format(" {}", cnf.equivalent(bit));
}

}  // namespace

std::string to_dimacs(const Graph& graph, const AddressTable& addresses, std::span<const NodeId> conditions) {
  Text text;
  Circuit circuit;
  Cnf cnf(circuit, text);
  BitBlaster blaster(graph, circuit, cnf);
  for (const NodeId condition : conditions) blaster.require(condition);
  std::string comments = kHeader;
  for (std::size_t i = 0; i < graph.variables().size(); ++i) {
    if (blaster.choices().inputs(i).empty()) continue;  // no condition depends on it
    const auto& [address, domain] = graph.variables()[i];
    comments += fmt::format("c choice {} = {}..{} step {}:", addresses.text(address), domain.lo, domain.hi,
                            domain.step);
    for (const Literal bit : blaster.choices().bits(i)) comments += bit_text(bit, cnf);
    comments += '\n';
  }
  return comments + text.problem(cnf.variables());
}

}  // namespace solitaire
