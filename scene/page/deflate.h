#pragma once
#include <string>
#include <string_view>

namespace solitaire {

/// Returns the bytes compressed as zlib's format has it, in base64: text that a script can hold and that a
/// browser unpacks by its own means. The same bytes give the same text.
std::string deflated_base64(std::string_view bytes);

}  // namespace solitaire
