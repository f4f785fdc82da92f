#include "tb/util/json.h"

#include <fmt/core.h>

#include <set>

#include "tb/util/words.h"

namespace cosim {

Json parse_json(const std::string& text, std::vector<std::string>& errors) {
  struct TooDeep {};
  std::vector<std::set<std::string>> open;  // the keys so far of the objects that are open
  const auto look = [&](int depth, Json::parse_event_t event, Json& value) {
    const bool is_object = event == Json::parse_event_t::object_start;
    const bool is_list = event == Json::parse_event_t::array_start;
    if ((is_object || is_list) && depth >= most_json_levels) throw TooDeep();
    if (is_object) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key) {
      const auto key = value.get<std::string>();
      if (!open.back().insert(key).second) {
        errors.push_back(fmt::format("{}: occurs twice in an object", in_quotes(key)));
      }
    }
    return true;
  };
  try {
    return Json::parse(text, look, true, true);
  } catch (const TooDeep&) {
    errors.push_back(fmt::format("no JSON, or more than {} levels deep", most_json_levels));
  } catch (const Json::exception& error) {
    // Only where it is and what: the rest is for the library's own users.
    const std::string what = error.what();
    const std::size_t at = what.find("at line ");
    errors.push_back("no JSON: " + (at == std::string::npos ? what : what.substr(at)));
  }
  return {};
}

Json json_of(const std::string& text) { return Json::parse(text); }

std::string json_text(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string json_short(const Json& json, std::size_t longest) {
  const std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

}  // namespace cosim
