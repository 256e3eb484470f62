// Problems that people post, as somebody writes them who has just read the manual. Comments of each script in
// tests/posted/ say what comes out:
//
//   // $ solve --all          the command, whose options follow
//   // status: 1              its exit status, 0 if nothing is said
//   // says: 42 solutions     what stands in what it prints, each in the order of these comments
#include <doctest/doctest.h>
#include <filesystem>
#include <sstream>

#include "tests/support/command.h"

namespace solitaire {
namespace {

namespace fs = std::filesystem;

/// What follows a mark in those lines that begin with it.
std::vector<std::string> marked(const std::string& text, const std::string& mark) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(mark, 0) == 0) found.push_back(line.substr(mark.size()));
  }
  return found;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream words(text);
  std::vector<std::string> made;
  for (std::string word; words >> word;) made.push_back(word);
  return made;
}

void check_posted(const fs::path& script) {
  const std::string text = bytes_of(script);
  const Workplace place;
  std::vector<std::string> command = words_of(marked(text, "// $ ").at(0));
  if (command[0] == "generate") command.insert(command.end(), {"-o", place / "out"});
  command.insert(command.begin() + 1, script);
  const Outcome outcome = run_solitaire(command);
  const auto status = marked(text, "// status: ");
  CHECK(outcome.status == (status.empty() ? 0 : std::stoi(status[0])));
  const std::string printed = outcome.out + outcome.err;
  std::size_t at = 0;
  for (const std::string& part : marked(text, "// says: ")) {
    const std::size_t found = printed.find(part, at);
    CHECK_MESSAGE(found != std::string::npos, "'" << part << "' in:\n" << printed);
    if (found != std::string::npos) at = found + part.size();
  }
}

TEST_CASE("posted: what people post has its right answer (slow)") {
  for (const auto& entry : fs::directory_iterator(SOLITAIRE_SOURCE_DIR "/tests/posted")) {
    if (entry.path().extension() != ".sol") continue;
    const std::string name = entry.path().filename().string();
    CAPTURE(name);
    check_posted(entry.path());
  }
}

TEST_CASE("posted: a library in a folder of its own places its own models") {
  const Workplace place;
  fs::create_directories(place / "shop/models");
  fs::copy(SOLITAIRE_SOURCE_DIR "/assets/chair.glb", place / "shop/models/stall.glb");
  place.file("shop/shop.sol", "fun stall(x) { place(\"models/stall.glb\", at: [x, 0]); }\n");
  const std::string script = place.file("main.sol", "import \"shop/shop.sol\";\nstall(range(0, 1));\n");
  const Outcome outcome = run_solitaire({"generate", script, "-n", "2", "-o", place / "out"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.find("no model is called so") == std::string::npos);
}

}  // namespace
}  // namespace solitaire
