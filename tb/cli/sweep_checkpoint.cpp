#include "tb/cli/sweep_checkpoint.h"

#include <exception>

#include "model/core/input_error.h"

namespace cosim::cli {
namespace {

using Json = Checkpoint::Json;

Json to_json(const Result& r) {
  return {{"cases", r.cases},
          {"clocks", r.clocks},
          {"jobs", r.checked.jobs},
          {"steps", r.checked.steps},
          {"max_deviation", r.checked.max_deviation}};
}

void get_count(const Json& j, const char* name, std::uint64_t& count) {
  if (!j.at(name).is_number_unsigned()) throw InputError(std::string(name) + ": no count");
  j.at(name).get_to(count);
}

Result from_json(const Json& j) {
  Result r;
  get_count(j, "cases", r.cases);
  get_count(j, "clocks", r.clocks);
  get_count(j, "jobs", r.checked.jobs);
  get_count(j, "steps", r.checked.steps);
  j.at("max_deviation").get_to(r.checked.max_deviation);
  return r;
}

}  // namespace

SweepCheckpoint::SweepCheckpoint(const std::string& path, const std::string& work)
    : path_(path), checkpoint_(path, work) {
  const Json state = checkpoint_.state();
  try {
    for (const Json& one : state) done_.push_back(from_json(one));
  } catch (const std::exception&) {
    fail();
  }
}

void SweepCheckpoint::fail() const { throw InputError(path_ + ": no checkpoint of these sweeps"); }

Resume SweepCheckpoint::resume(std::size_t i, std::uint64_t cases) {
  if (done_.size() <= i) done_.resize(i + 1);
  if (done_[i].cases > cases) fail();
  const auto keep = [this, i](const Result& done) {
    done_[i] = done;
    if (!checkpoint_.due()) return;
    Json state = Json::array();
    for (const Result& one : done_) state.push_back(to_json(one));
    checkpoint_.save(state);
  };
  return {done_[i], keep};
}

}  // namespace cosim::cli
