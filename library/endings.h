#pragma once
#include <solitaire/search.h>

#include "engines/engine.h"

namespace solitaire::api {

Ending public_ending(solitaire::Ending ending);

}  // namespace solitaire::api
