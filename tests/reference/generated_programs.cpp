// Writes generated programs to standard output, a line of JSON each, for tests/reference:
//
//   generated_programs FIRST-SEED COUNT
#include <cstdint>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/generator/program_generator.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: generated_programs FIRST-SEED COUNT\n";
    return 2;
  }
  const std::uint64_t first = std::stoull(argv[1]);
  const std::uint64_t end = first + std::stoull(argv[2]);
  for (std::uint64_t seed = first; seed < end; ++seed) {
    solitaire::ByteSource bytes(seed);
    nlohmann::json files = nlohmann::json::array();
    for (const solitaire::SourceText& file : solitaire::generate_program(bytes).files) {
      files.push_back({{"name", file.name}, {"text", file.text}});
    }
    std::cout << nlohmann::json{{"seed", seed}, {"files", files}} << "\n";
  }
}
