#include "tb/support/json.h"

namespace cosim {

Json json_of(const std::string& text) { return Json::parse(text); }

Json json_if(const std::string& text) { return Json::parse(text, nullptr, false); }

std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string json_ascii(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace cosim
