#pragma once
#include <string>
#include <string_view>

namespace solitaire {

/// Returns valid UTF-8 without control characters: each broken sequence becomes U+FFFD, each control a space.
std::string clean_text(std::string_view text);

/// Returns clean_text(text), escaped for element content and quoted attributes of HTML and SVG alike.
std::string escape_markup(std::string_view text);

/// Returns a link to a file beside the page, whatever characters its name has. "./" keeps "a:b.glb" from
/// being a scheme.
std::string relative_link(std::string_view file);

/// Returns true if the text has this as one of its words, which end where a letter is followed by something
/// else.
bool has_word(std::string_view text, std::string_view word);

/// Estimates how wide a text is set, in multiples of the font size. The estimate is on the wide side for a
/// sans-serif face.
double text_width(std::string_view utf8);

}  // namespace solitaire
