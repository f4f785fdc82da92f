#include "tb/regress/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "tb/util/words.h"

namespace cosim::regress {
namespace {

using Type = Key::Type;

constexpr std::uint64_t most = ~std::uint64_t{0};

// Those that every task has.
const std::vector<Key>& common_keys() {
  static const std::vector<Key> keys{
      {"name", Type::text, "Names the task in the report; each has a name of its own"},
      {"seed", Type::number, "Of all that is random in it; default that of the run", 0, most},
      {"minutes", Type::number,
       "Processor time that the whole task is expected to take; default 1. It is divided by this",
       1, 10'000'000},
      {"memory", Type::number,
       "In MB, that a part of it may take on a cluster; default what is usual there", 1,
       10'000'000}};
  return keys;
}

// Collects what is wrong, with its place.
class Complaints {
 public:
  Complaints(const std::string& path, std::vector<std::string>& errors)
      : path_(path), errors_(errors) {}
  void add(const std::string& place, const std::string& what) const {
    errors_.push_back(
        one_line(fmt::format("{}: {}{}{}", path_, place, place.empty() ? "" : ": ", what)));
  }

 private:
  const std::string& path_;
  std::vector<std::string>& errors_;
};

// Empty where the value is of the key's type.
std::string wrong_in(const Key& key, const Json& value) {
  switch (key.type) {
    case Type::text:
      return value.is_string() && !value.get<std::string>().empty() ? "" : "needs a text";
    case Type::yes:
      return value == true ? "" : "can only be true";
    case Type::words:
      if (!value.is_array() || value.empty()) return "needs a list of texts";
      return std::all_of(value.begin(), value.end(), [](const Json& j) { return j.is_string(); })
                 ? ""
                 : "needs a list of texts";
    case Type::number:
      break;
  }
  const bool in_range = value.is_number_unsigned() && value.get<std::uint64_t>() >= key.low &&
                        value.get<std::uint64_t>() <= key.high;
  if (in_range) return "";
  return key.high == most ? "needs a whole number"
                          : fmt::format("needs a whole number from {} to {}", key.low, key.high);
}

const Key* find(const std::vector<Key>& keys, const std::string& name) {
  const auto found = std::ranges::find(keys, name, &Key::name);
  return found == keys.end() ? nullptr : &*found;
}

// The same of a name, which is shown on the terminal and in reports as it is.
std::string wrong_in_name(const Json& value) {
  if (!value.is_string() || value.get<std::string>().empty()) return "needs a text";
  const auto name = value.get<std::string>();
  return one_line(name) == name ? "" : "needs printable characters on one line";
}

// The kind whose name is a key of the task; null where there is not one.
const Keys* kind_of(const Json& task, const std::vector<Keys>& kinds, const std::string& place,
                    const Complaints& complaints) {
  const Keys* found = nullptr;
  std::vector<std::string> names;
  for (const Keys& one : kinds) {
    names.push_back('"' + one.kind + '"');
    if (!task.contains(one.kind)) continue;
    if (found != nullptr) {
      complaints.add(place, fmt::format("both \"{}\" and \"{}\"", found->kind, one.kind));
      return nullptr;
    }
    found = &one;
  }
  if (found == nullptr) {
    complaints.add(place, fmt::format("has none of {}", fmt::join(names, ", ")));
  }
  return found;
}

void read_task(const Json& json, const std::vector<Keys>& kinds, const Complaints& complaints,
               Task& task) {
  if (!json.is_object()) return complaints.add(task.place, "is no object");
  const Keys* kind = kind_of(json, kinds, task.place, complaints);
  if (kind == nullptr) return;
  task.kind = kind->kind;
  for (const auto& [name, value] : json.items()) {
    const std::string place = task.place + '.' + name;
    const Key* common = find(common_keys(), name);
    const Key* key = common != nullptr ? common : find(kind->keys, name);
    if (key == nullptr) {
      complaints.add(place, fmt::format("no such key of \"{}\"", kind->kind));
    } else if (const std::string wrong =
                   name == "name" ? wrong_in_name(value) : wrong_in(*key, value);
               !wrong.empty()) {
      complaints.add(place, wrong);
    } else if (common == nullptr) {
      task.values[name] = value;
    } else if (name == "name") {
      task.name = value;
    } else if (name == "seed") {
      task.seed = value;
    } else if (name == "minutes") {
      task.minutes = value;
    } else {
      task.memory = value;
    }
  }
  if (!json.contains("name")) complaints.add(task.place, "name: is needed");
}

Json schema_of(const Key& key) {
  Json json;
  switch (key.type) {
    case Type::text:
      json = {{"type", "string"}, {"minLength", 1}};
      break;
    case Type::yes:
      json = {{"const", true}};
      break;
    case Type::words:
      json = {{"type", "array"}, {"minItems", 1}, {"items", {{"type", "string"}}}};
      break;
    case Type::number:
      json = {{"type", "integer"}, {"minimum", key.low}, {"maximum", key.high}};
      break;
  }
  json["description"] = key.meaning;
  return json;
}

}  // namespace

std::string Task::text(const std::string& key, const std::string& otherwise) const {
  return has(key) ? values.at(key).get<std::string>() : otherwise;
}
std::uint64_t Task::number(const std::string& key, std::uint64_t otherwise) const {
  return has(key) ? values.at(key).get<std::uint64_t>() : otherwise;
}

Plan read_plan(const std::string& text, const std::string& path, const std::vector<Keys>& kinds,
               std::uint64_t seed, std::vector<std::string>& errors) {
  const Complaints complaints(path, errors);
  Plan plan;
  std::vector<std::string> wrong_json;
  const Json json = parse_json(text, wrong_json);
  for (const std::string& one : wrong_json) complaints.add("", one);
  if (json.is_null() && !wrong_json.empty()) return plan;
  if (!json.is_object() || !json.contains("format") || json["format"] != format) {
    complaints.add("", fmt::format("no plan: needs an object with \"format\": {}", format));
    return plan;
  }
  const std::vector<Key> top{{"format", Type::number, "", format, format},
                             {"name", Type::text, ""},
                             {"seed", Type::number, "", 0, most}};
  for (const auto& [name, value] : json.items()) {
    const Key* key = find(top, name);
    if (name == "tasks") continue;
    const std::string wrong = key == nullptr   ? "no such key"
                              : name == "name" ? wrong_in_name(value)
                                               : wrong_in(*key, value);
    if (!wrong.empty()) complaints.add(name, wrong);
  }
  if (json.contains("name") && json["name"].is_string()) plan.name = json["name"];
  if (!json.contains("name")) complaints.add("name", "is needed");
  plan.seed = seed;
  if (json.contains("seed") && json["seed"].is_number_unsigned()) plan.seed = json["seed"];
  if (!json.contains("tasks") || !json["tasks"].is_array() || json["tasks"].empty()) {
    complaints.add("tasks", "needs a list of tasks");
    return plan;
  }
  std::set<std::string> names;
  for (const Json& one : json["tasks"]) {
    Task task;
    task.place = fmt::format("tasks[{}]", plan.tasks.size());
    task.seed = plan.seed;
    read_task(one, kinds, complaints, task);
    if (!task.name.empty() && !names.insert(task.name).second) {
      complaints.add(task.place + ".name", in_quotes(task.name) + " names another task already");
    }
    plan.tasks.push_back(std::move(task));
  }
  return plan;
}

Json to_json(const Plan& plan) {
  Json tasks = Json::array();
  for (const Task& t : plan.tasks) {
    Json one{{"name", t.name}};
    one.update(t.values);
    one["seed"] = t.seed;
    one["minutes"] = static_cast<std::uint64_t>(t.minutes);
    if (t.memory != 0) one["memory"] = t.memory;
    tasks.push_back(std::move(one));
  }
  return {{"format", format}, {"name", plan.name}, {"seed", plan.seed}, {"tasks", tasks}};
}

Json schema(const std::vector<Keys>& kinds) {
  Json tasks = Json::array();
  for (const Keys& kind : kinds) {
    Json one{{"type", "object"},
             {"required", {"name", kind.kind}},
             {"additionalProperties", false},
             {"properties", Json::object()}};
    for (const auto* keys : {&common_keys(), &kind.keys}) {
      for (const Key& key : *keys) one["properties"][key.name] = schema_of(key);
    }
    tasks.push_back(std::move(one));
  }
  return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
          {"title", "A regression"},
          {"type", "object"},
          {"required", {"format", "name", "tasks"}},
          {"additionalProperties", false},
          {"properties",
           {{"format", {{"const", format}}},
            {"name", {{"type", "string"}, {"minLength", 1}}},
            {"seed",
             {{"type", "integer"},
              {"minimum", 0},
              {"description", "Of the run; without it every run has one of its own"}}},
            {"tasks", {{"type", "array"}, {"minItems", 1}, {"items", {{"oneOf", tasks}}}}}}}};
}

}  // namespace cosim::regress
