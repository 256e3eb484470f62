#include "tests/sample/random_model.h"

#include <fmt/format.h>
#include <vector>

namespace solitaire {
namespace {

class ModelWriter {
 public:
  explicit ModelWriter(ByteSource& bytes) : bytes_(bytes) {}

  std::string text() {
    const std::uint32_t statements = 3 + bytes_.below(4);
    draw();
    for (std::uint32_t i = 1; i < statements; ++i) statement();
    std::string returned = "0";
    for (const std::string& name : names_) returned = fmt::format("5 * ({}) + {}", returned, name);
    return text_ + "return " + returned + ";\n";
  }

 private:
  /// A probability or weight that is neither 0 nor 1.
  std::string share() { return fmt::format("0.{}", 1 + bytes_.below(9)); }
  std::string earlier() { return names_[bytes_.below(static_cast<std::uint32_t>(names_.size()))]; }
  std::string condition() { return fmt::format("{} > {}", earlier(), bytes_.below(2)); }

  /// An int from 0 to 4.
  std::string choice() {
    switch (bytes_.below(5)) {
      case 0:
        return fmt::format("range(0, {})", 1 + bytes_.below(3));
      case 1:
        return fmt::format("cond(flip({}), 1, 0)", share());
      case 2:
        return fmt::format("choose([0, 1, 3], weights: [{}, {}, {}])", share(), share(), share());
      case 3:
        return fmt::format("categorical([{}, {}])", share(), share());
      default:
        return names_.empty() ? "range(0, 2)" : fmt::format("range({0}, min({0} + 2, 4))", earlier());
    }
  }

  void draw() {
    const std::string name = fmt::format("x{}", names_.size());
    const std::uint32_t kind = names_.empty() ? 0 : bytes_.below(4);
    if (kind == 1) {
      text_ += fmt::format("{} = if {} then {} else {};\n", name, condition(), choice(), bytes_.below(2));
    } else if (kind == 2) {
      text_ += fmt::format("{} = if {} then {} else {};\n", name, condition(), choice(), choice());
    } else if (kind == 3) {
      text_ += fmt::format("{0} = 0;\nfor i in 1..{1} {{ {0} = min(4, {0} + cond(flip({2}), 1, 0)); }}\n",
                           name, earlier(), share());
    } else {
      text_ += fmt::format("{} = {};\n", name, choice());
    }
    names_.push_back(name);
  }

  void statement() {
    switch (bytes_.below(7)) {
      case 0:
        text_ += fmt::format("factor({} * {});\n", share(), earlier());
        break;
      case 1:
        text_ += fmt::format("prefer({}, 1);\n", condition());
        break;
      case 2:
        text_ += fmt::format("observe(Flip(if {} then {} else {}), true);\n", condition(), share(), share());
        break;
      case 3:
        text_ += fmt::format("assert({} + {} != {});\n", earlier(), earlier(), 3 + 2 * bytes_.below(2));
        break;
      default:
        draw();
    }
  }

  ByteSource& bytes_;
  std::string text_;
  std::vector<std::string> names_;
};

}  // namespace

std::string random_model(ByteSource& bytes) { return ModelWriter(bytes).text(); }

}  // namespace solitaire
