#include "tb/regress/parse.h"

#include <fmt/core.h>

#include <set>

#include "tb/support/json.h"
#include "tb/support/words.h"

namespace cosim::regress {

Json parse(const std::string& text, std::vector<std::string>& errors) {
  std::vector<std::set<std::string>> open;  // the keys so far of the objects that are open
  const auto look = [&](int, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key) {
      const auto key = value.get<std::string>();
      if (!open.back().insert(key).second) {
        errors.push_back(fmt::format("{}: stands twice in an object", in_quotes(key)));
      }
    }
    return true;
  };
  try {
    return Json::parse(text, look, true, true);
  } catch (const Json::exception& error) {
    // Only where it is and what: the rest is for the library's own users.
    const std::string what = error.what();
    const std::size_t at = what.find("at line ");
    errors.push_back("no JSON: " + (at == std::string::npos ? what : what.substr(at)));
    return {};
  }
}

}  // namespace cosim::regress
