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
  std::string facts = "{}";  // a JSON object: what the page's scripts know of the run
};

struct GalleryEntry {
  std::size_t index = 0;  // of the solution, from 1
  std::string name;       // "office-0001"
  std::string plan;       // an SVG's file name, or "" for a program that places nothing
  std::string glb;        // file names relative to the page; "" for none
  std::string json;
  std::string value;  // the solution's value as short text, or ""
  std::size_t choices = 0;
  std::vector<std::string> remarks;  // lines below the value
  std::string picture;               // a PNG's file name, or "" where the plan stands for it
  std::string facts = "{}";          // a JSON object: what the page sorts and filters solutions by
  bool has_sharp_pixels = false;     // the picture's pixels are not blurred where it is enlarged
};

/// Returns an HTML page that shows the entries in the order given. The scripts and the style sheet in page/
/// beside it make it a viewer; without scripts it still shows pictures, values and links. Nothing is loaded
/// from a network.
std::string gallery_html(const GalleryInfo& info, const std::vector<GalleryEntry>& entries);

}  // namespace solitaire
