#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace solitaire {

/// What the page says above the solutions.
struct GalleryInfo {
  std::string title;    // the program's name
  std::string program;  // its file
  std::string seed;
  std::vector<std::pair<std::string, std::string>> options;  // further facts: name, value
};

struct GalleryEntry {
  std::size_t index = 0;  // of the solution, from 1
  std::string name;       // "office-0001"
  std::string plan;       // svg_plan's element, or "" for a program that places nothing
  std::string glb;        // file names relative to the page; "" for none
  std::string json;
  std::string value;  // the solution's value as short text, or ""
  std::size_t choices = 0;
  std::vector<std::string> remarks;  // lines below the value
  std::string picture;               // a PNG's file name, or "" where the plan stands for it
};

/// Returns a self-contained HTML page without scripts, which loads nothing from a network. It shows the
/// entries in the order given. It holds a light and a dark theme and follows the reader's.
std::string gallery_html(const GalleryInfo& info, const std::vector<GalleryEntry>& entries);

}  // namespace solitaire
