#include "tb/util/json_at.h"

#include <fmt/core.h>

#include <utility>

#include "model/core/input_error.h"
#include "tb/util/json.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

// A value, short enough for an error.
std::string shown(const Json& value) {
  if (value.is_array()) return fmt::format("a list of {}", value.size());
  if (value.is_object()) return "an object";
  return json_short(value, 60);
}

Json checked(const std::string& path, const std::string& text) {
  std::vector<std::string> errors;
  Json value = parse_json(text, errors);
  if (!errors.empty()) throw InputError(one_line(path + ": " + errors.front()));
  return value;
}

}  // namespace

JsonAt::JsonAt(const std::string& path, const std::string& text)
    : JsonAt(path, std::make_shared<const Json>(checked(path, text))) {}
JsonAt::JsonAt(std::string path, std::shared_ptr<const Json> root)
    : path_(std::move(path)), root_(std::move(root)), value_(root_.get()) {}
JsonAt::JsonAt(const JsonAt& parent, const Json& value, std::string place)
    : path_(parent.path_), place_(std::move(place)), root_(parent.root_), value_(&value) {}

JsonAt JsonAt::of(std::string path, Json value) {
  return {std::move(path), std::make_shared<const Json>(std::move(value))};
}

void JsonAt::fail(const std::string& what) const {
  const std::string& place = place_.empty() ? "it" : place_;
  throw InputError(one_line(fmt::format("{}: {} {}", path_, place, what)));
}

void JsonAt::wrong(const std::string& wanted) const {
  fail(fmt::format("is {}, not {}", shown(*value_), wanted));
}

std::optional<JsonAt> JsonAt::find(const std::string& key) const {
  if (!value_->is_object()) wrong("an object");
  const auto found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return JsonAt(*this, *found, place_.empty() ? key : place_ + '.' + key);
}

JsonAt JsonAt::at(const std::string& key) const {
  if (auto found = find(key)) return *std::move(found);
  fail(fmt::format("has no {}", in_quotes(key)));
}

std::vector<JsonAt> JsonAt::list(std::size_t least, std::size_t most) const {
  if (!value_->is_array()) wrong("a list");
  const std::size_t size = value_->size();
  if (size < least || size > most) {
    wrong(least == most  ? fmt::format("of {}", least)
          : size < least ? fmt::format("of {} or more", least)
                         : fmt::format("of at most {}", most));
  }
  std::vector<JsonAt> all;
  all.reserve(size);
  for (std::size_t i = 0; i < size; ++i) {
    all.push_back(JsonAt(*this, (*value_)[i], fmt::format("{}[{}]", place_, i)));
  }
  return all;
}

std::string JsonAt::text() const {
  if (!value_->is_string()) wrong("a text");
  return value_->get<std::string>();
}

bool JsonAt::yes() const {
  if (!value_->is_boolean()) wrong("true or false");
  return value_->get<bool>();
}

std::uint64_t JsonAt::whole(std::uint64_t low, std::uint64_t high) const {
  if (value_->is_number_unsigned()) {
    const auto value = value_->get<std::uint64_t>();
    if (low <= value && value <= high) return value;
  }
  wrong(low == high ? fmt::format("{}", low)
                    : fmt::format("a whole number from {} to {}", low, high));
}

double JsonAt::number(double low, double high) const {
  if (value_->is_number()) {
    const auto value = value_->get<double>();
    if (low <= value && value <= high) return value;
  }
  wrong(fmt::format("a number from {} to {}", low, high));
}

}  // namespace cosim
