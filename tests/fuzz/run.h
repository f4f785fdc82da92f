// The folder of a run whose works are units of nothing, for what is read back from such folders.
#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "tb/regress/report.h"
#include "tb/util/hash.h"
#include "tb/util/json.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"
#include "tests/fuzz/expect.h"

namespace cosim::fuzz {

/// The value, where the text is JSON of an object; null where not.
inline Json object_of(const std::string& text) {
  std::vector<std::string> errors;
  Json json = parse_json(text, errors);
  return errors.empty() && json.is_object() ? json : Json();
}

inline void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Merges as `merge` says.
class Units final : public regress::Work {
 public:
  using Merge = Json (*)(const std::vector<regress::Part>& parts);
  Units(const std::string& title, std::uint64_t units, Merge merge)
      : Work(title, units), merge_(merge) {}
  bool ends_at_failure() const override { return true; }
  Json run(std::uint64_t, std::uint64_t, const regress::Place&) const override { return {}; }
  Json merged(const std::vector<regress::Part>& parts) const override { return merge_(parts); }

 private:
  Merge merge_;
};

class UnitsKind final : public regress::Kind {
 public:
  explicit UnitsKind(Units::Merge merge) : merge_(merge) {}
  regress::Keys keys() const override {
    return {"units", {{"units", regress::Key::Type::number, "How many", 1, 1000}}};
  }
  regress::Works works(const regress::Task& task, const std::filesystem::path&) const override {
    regress::Works works;
    works.push_back(std::make_unique<Units>("all", task.number("units"), merge_));
    works.push_back(std::make_unique<Units>("some", 7, merge_));
    return works;
  }

 private:
  Units::Merge merge_;
};

/// A run of two tasks of two works each, in a folder that goes with this object.
class RunInAFolder {
 public:
  explicit RunInAFolder(Units::Merge merge) {
    kinds_.push_back(std::make_unique<UnitsKind>(merge));
    std::vector<std::string> errors;
    const regress::Plan plan = regress::read_plan(R"({"format": 1, "name": "n", "seed": 1, "tasks":
      [{"name": "a", "units": 300}, {"name": "b", "units": 2}]})",
                                                  "plan", keys_of(kinds_), 0, errors);
    regress::RunFolder::make(path(), plan, kinds_, scratch_.path(), 20, false);
  }

  std::filesystem::path path() const { return scratch_.path() / "run"; }
  const regress::Kinds& kinds() const { return kinds_; }

 private:
  Scratch scratch_;
  regress::Kinds kinds_;
};

}  // namespace cosim::fuzz
