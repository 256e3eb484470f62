#pragma once
#include <string>

#include "tests/generator/byte_source.h"

namespace solitaire {

/// The text of a program with a few finite choices, some of which decide about others, and with factors,
/// wishes, observations and asserts. It returns an int that tells apart what it chose; some of its executions
/// are possible, at least where all asserts can hold.
std::string random_model(ByteSource& bytes);

}  // namespace solitaire
