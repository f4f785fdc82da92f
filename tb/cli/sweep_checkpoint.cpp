#include "tb/cli/sweep_checkpoint.h"

#include "tb/cli/result_json.h"
#include "tb/util/json.h"

namespace cosim::cli {

SweepCheckpoint::SweepCheckpoint(const std::string& path, const std::string& work)
    : checkpoint_(path, work) {
  if (const auto state = checkpoint_.state()) kept_ = state->list();
}

Resume SweepCheckpoint::resume(const AnyBench& bench, std::uint64_t cases) {
  const std::size_t i = done_.size();
  done_.emplace_back();
  if (i < kept_.size()) {
    kept_[i].at("cases").whole(0, cases);
    done_[i] = result_from(kept_[i], bench);
  }
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
