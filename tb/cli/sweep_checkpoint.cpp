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

Result from_json(const Json& j) {
  Result r;
  j.at("cases").get_to(r.cases);
  j.at("clocks").get_to(r.clocks);
  j.at("jobs").get_to(r.checked.jobs);
  j.at("steps").get_to(r.checked.steps);
  j.at("max_deviation").get_to(r.checked.max_deviation);
  return r;
}

}  // namespace

SweepCheckpoint::SweepCheckpoint(const std::string& path, const std::string& work)
    : checkpoint_(path, work) {
  try {
    for (const Json& one : checkpoint_.state()) done_.push_back(from_json(one));
  } catch (const nlohmann::json::exception&) {
    throw InputError(path + ": no checkpoint of sweeps");
  }
}

Resume SweepCheckpoint::resume(std::size_t i) {
  if (done_.size() <= i) done_.resize(i + 1);
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
