#include "tb/cli/sweep_checkpoint.h"

#include <exception>

#include "model/core/input_error.h"
#include "tb/cli/result_json.h"
#include "tb/support/json.h"

namespace cosim::cli {

SweepCheckpoint::SweepCheckpoint(const std::string& path, const std::string& work)
    : path_(path), checkpoint_(path, work) {
  const Json state = checkpoint_.state();
  try {
    for (const Json& one : state) done_.push_back(result_from(one));
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
