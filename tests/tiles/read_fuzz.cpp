// Hands bytes to the readers of maps. Whatever they are, a reader returns or throws FileError.
#include <cstddef>
#include <cstdint>
#include <string>

#include "base/file_error.h"
#include "engines/tiles/read/json.h"
#include "engines/tiles/read/png.h"
#include "engines/tiles/read/text.h"
#include "engines/tiles/read/vox.h"
#include "engines/tiles/request/debroglie.h"
#include "engines/tiles/request/request_file.h"
#include "engines/tiles/tiled/tiled_map.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace solitaire::tiles;
  if (size < 2) return 0;
  const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  Tileset tileset;
  try {
    switch (data[0] % 11) {
      case 0:
        read_text("fuzz", bytes, tileset, true);
        break;
      case 1:
        read_json("fuzz", bytes, tileset, true);
        break;
      case 2:
        cut_tiles("fuzz", read_png("fuzz", bytes), 1, tileset, true);
        break;
      case 3:
        decode_gids("fuzz", bytes, "csv", "", 100);
        break;
      case 4:
        read_tmx("fuzz", bytes);
        break;
      case 5:
        read_tmj("fuzz", bytes);
        break;
      case 6:
        read_vox("fuzz", bytes, tileset, true);
        break;
      case 7:
        decode_gids("fuzz", bytes, "base64", "zstd", 100);
        break;
      case 8:
        parse_debroglie("nowhere/fuzz.json", bytes);
        break;
      case 9:
        parse_request("nowhere/fuzz.tiles.json", bytes);
        break;
      default:
        decode_gids("fuzz", bytes, "base64", "zlib", 100);
    }
  } catch (const solitaire::FileError&) {
  }
  return 0;
}
