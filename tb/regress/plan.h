// A regression as a person writes it: a JSON file that lists tasks. // and /* */ comments are
// allowed.
//
//   {"format": 1, "name": "nightly", "tasks": [
//     {"name": "any pins", "sweep": "uart", "hostile": 1000000, "minutes": 2}]}
//
// A task is of the kind whose name is one of its keys. Which keys a kind has stands in its table.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/util/json.h"

namespace cosim::regress {

/// Of plans, of runs' folders and of reports.
inline constexpr int format = 1;

/// A key of a task.
struct Key {
  enum class Type { text, number, yes, words };
  std::string name;
  Type type = Type::text;
  std::string meaning;
  std::uint64_t low = 0, high = 0;  ///< of a number
};

/// The keys of a kind of task. The first is the kind's name and says what is worked on.
struct Keys {
  std::string kind;
  std::vector<Key> keys;
};

struct Task {
  std::string place;  ///< in the file: "tasks[2]"
  std::string name, kind;
  Json values;               ///< of the kind's keys, of the right types and in range
  std::uint64_t seed = 0;    ///< its own, or that of the run
  double minutes = 1;        ///< of processor time that all of it is thought to take
  std::uint64_t memory = 0;  ///< in MB, that a part of it may take on a cluster; 0: what is usual

  std::string text(const std::string& key, const std::string& otherwise = "") const;
  std::uint64_t number(const std::string& key, std::uint64_t otherwise = 0) const;
  bool has(const std::string& key) const { return values.contains(key); }
};

struct Plan {
  std::string name;
  std::uint64_t seed = 0;  ///< of the run
  std::vector<Task> tasks;
};

/// The plan in `text`, the contents of `path`. What is wrong is added to `errors`, a line each with
/// the file and the place in it; the plan then holds what is right. `seed`: of the run where the
/// plan names none.
Plan read_plan(const std::string& text, const std::string& path, const std::vector<Keys>& kinds,
               std::uint64_t seed, std::vector<std::string>& errors);

/// The plan as JSON from which read_plan makes the same one, whatever `seed` it is given.
Json to_json(const Plan& plan);

/// What a plan may hold, as a JSON Schema for editors.
Json schema(const std::vector<Keys>& kinds);

}  // namespace cosim::regress
