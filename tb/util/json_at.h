// JSON that is read back from a file, whatever stands in it now: each value is taken with what it
// is to be, and what is not so is one line with the file and the place in it, "FILE: tasks[3].units
// is -1, not a whole number from 1 to 1000".
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tb/util/json_fwd.h"

namespace cosim {

/// A value and where it stands. All functions throw InputError where it is not what they ask for.
class JsonAt {
 public:
  /// Of `text`, the contents of `path`: JSON of at most most_json_levels, no key twice in an
  /// object.
  JsonAt(const std::string& path, const std::string& text);
  /// Of a value that was read before; `path` is what errors begin with.
  static JsonAt of(std::string path, Json value);

  /// The value of a key of this object.
  JsonAt at(const std::string& key) const;
  /// The same; none where the object has no such key.
  std::optional<JsonAt> find(const std::string& key) const;
  /// The values of this list, which has at least `least` and at most `most`.
  std::vector<JsonAt> list(std::size_t least = 0, std::size_t most = ~std::size_t{0}) const;

  std::string text() const;
  bool yes() const;
  /// A whole number, low to high.
  std::uint64_t whole(std::uint64_t low = 0, std::uint64_t high = ~std::uint64_t{0}) const;
  /// Any number, low to high.
  double number(double low, double high) const;

  /// InputError: its file and place, and then `what`.
  [[noreturn]] void fail(const std::string& what) const;
  const Json& json() const { return *value_; }

 private:
  JsonAt(std::string path, std::shared_ptr<const Json> root);
  JsonAt(const JsonAt& parent, const Json& value, std::string place);
  [[noreturn]] void wrong(const std::string& wanted) const;

  std::string path_, place_;
  std::shared_ptr<const Json> root_;
  const Json* value_;
};

}  // namespace cosim
