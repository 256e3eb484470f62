#include "tests/support/scripts.h"

#include <algorithm>
#include <iterator>

#include "base/file_provider.h"

namespace solitaire {
namespace {

constexpr const char* kPieces[] = {"(",     ")",     "[",      "]",      "{",    "}",        ";",     ",",
                                   ":",     "..",    "=",      "==",     "+",    "-",        "not",   "and",
                                   "if",    "then",  "else",   "for",    "in",   "fun",      "x",     "\"",
                                   "/*",    "*/",    "//",     "0",      "1.5",  "record",   "param", ".",
                                   "while", "break", "return", "import", "\xff", "\xe2\x82", "\n",    "\t"};

}  // namespace

std::vector<std::filesystem::path> project_scripts() {
  std::vector<std::filesystem::path> paths;
  for (const char* folder : {"examples", "solitaire/std", "tests"}) {
    const auto root = std::filesystem::path(SOLITAIRE_SOURCE_DIR) / folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
      if (entry.path().extension() == ".sol") paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::vector<std::string> all_scripts() {
  std::vector<std::string> texts;
  for (const std::filesystem::path& path : project_scripts()) texts.push_back(read_source(path));
  return texts;
}

const char* random_piece(std::mt19937_64& random) { return kPieces[random() % std::size(kPieces)]; }

std::string mutated(std::string text, const std::vector<std::string>& others, std::mt19937_64& random) {
  const auto below = [&](std::size_t bound) { return bound == 0 ? 0 : random() % bound; };
  for (auto changes = 1 + below(4); changes > 0; --changes) {
    const std::size_t at = below(text.size());
    const std::size_t length = 1 + below(below(8) == 0 ? 200 : 6);
    switch (below(6)) {
      case 0:
        text.erase(std::min(at, text.size()), length);
        break;
      case 1:
        text.insert(at, random_piece(random));
        break;
      case 2:
        text.insert(below(text.size()), text.substr(at, length));
        break;
      case 3:
        text.resize(at);
        break;
      case 4:
        if (!text.empty()) text[at] = static_cast<char>(random());
        break;
      default: {
        const std::string& other = others[below(others.size())];
        text.insert(at, other.substr(below(other.size()), length * 10));
      }
    }
  }
  return text;
}

}  // namespace solitaire
