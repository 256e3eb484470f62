#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace solitaire {

/// Valid UTF-8 without control characters: broken bytes become U+FFFD, controls a space.
std::string clean_text(std::string_view text);

/// clean_text, escaped for element content and quoted attributes of HTML and SVG alike.
std::string escape_markup(std::string_view text);

/// About how wide a text is set, in multiples of the font size; on the wide side for a sans-serif face.
double text_width(std::string_view utf8);

}  // namespace solitaire
