#include "engines/tiles/request/read_inputs.h"

#include "engines/tiles/request/debroglie.h"
#include "engines/tiles/request/request_error.h"
#include "engines/tiles/request/request_file.h"

namespace solitaire::tiles {

Request read_inputs(const std::vector<std::string>& inputs, bool debroglie) {
  if (debroglie) {
    if (inputs.size() != 1) throw RequestError("--debroglie goes with one configuration file");
    return read_debroglie(inputs[0]);
  }
  if (inputs.size() == 1 && inputs[0].ends_with(".tiles.json")) return read_request(inputs[0]);
  Request request;
  for (const std::string& input : inputs) request.exemplars.push_back({input, "", false, {}});
  return request;
}

}  // namespace solitaire::tiles
