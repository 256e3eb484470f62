#pragma once
#include <string>

namespace solitaire {

/// A drawing of a scene.
struct View {
  std::string kind;   // "plan", "front", "side" or "isometric"
  std::string title;  // "Plan", "Plan, from 2.8 m"
  std::string svg;    // an <svg> element
};

}  // namespace solitaire
