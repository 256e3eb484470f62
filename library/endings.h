#pragma once
#include <solitaire/search.h>

#include "engines/solution_stream.h"

namespace solitaire::api {

Ending public_ending(solitaire::Ending ending);

}  // namespace solitaire::api
