#include "model/toolpath/source.h"

#include "model/core/input_error.h"

namespace cosim::toolpath {
namespace {

std::string printable(std::string_view name) {
  std::string text(name);
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) c = '?';
  }
  return text;
}

}  // namespace

void fail(std::string_view name, Place place, std::string_view what) {
  throw InputError(printable(name) + ":" + std::to_string(place.line) + ":" +
                   std::to_string(place.column) + ": " + std::string(what));
}

}  // namespace cosim::toolpath
