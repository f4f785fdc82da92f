#include "tb/regress/local.h"

#include <fmt/core.h>

#include <chrono>
#include <future>
#include <mutex>

#include "tb/util/parallel.h"
#include "tb/util/process.h"
#include "tb/util/words.h"

namespace cosim::regress {
namespace {

// What the processes share.
class Pool {
 public:
  Pool(const RunFolder& run, const Kinds& kinds, const LocalOptions& options)
      : run_(run),
        options_(options),
        ends_(ends_at_failure(run, kinds)),
        over_(run.works().size()) {
    const Results results =
        read_results(run.path() / "results", run.identity(), run.shards().size());
    wanted_ = missing(run, results, ends_);
    tally_ = tally_of(run, results);
    tally_.errors = 0;
    if (options.fail_fast && tally_.failed != 0) wanted_.clear();
  }

  Errors work() {
    auto all = std::async(std::launch::async, [&] {
      in_parallel(wanted_.size(), options_.jobs,
                  [&](std::uint64_t i) { return shard(wanted_[i]); });
    });
    while (all.wait_for(std::chrono::milliseconds(200)) != std::future_status::ready) {
      options_.tell(tally());
    }
    all.get();
    options_.tell(tally());
    return errors_;
  }

 private:
  Tally tally() {
    const std::lock_guard lock(guard_);
    return tally_;
  }

  bool shard(std::uint64_t number) {
    const std::size_t work = run_.shards()[number].work;
    {
      const std::lock_guard lock(guard_);
      if (stopped_) return false;
      if (over_[work]) return true;
      ++tally_.running;
    }
    const Ended ended =
        cosim::run_program({run_.program().string(), "regress", "--work", run_.path().string(),
                            "--only", std::to_string(number)});
    const std::lock_guard lock(guard_);
    --tally_.running;
    if (ended.status > 1) {
      ++tally_.errors;
      errors_[number] = said(ended);
      return true;
    }
    ++tally_.done;
    tally_.done_minutes += run_.minutes(number);
    if (ended.status == 0) return true;
    ++tally_.failed;
    over_[work] = over_[work] || ends_[work];
    stopped_ = options_.fail_fast;
    return true;
  }

  // Its last line, without the program's name; or how it died.
  static std::string said(const Ended& ended) {
    const std::string text = ended.text.substr(0, ended.text.find_last_not_of('\n') + 1);
    const std::string last = text.substr(text.find_last_of('\n') + 1);
    const std::string name = program_name() + ": ";
    if (ended.status == 2) return last.starts_with(name) ? last.substr(name.size()) : last;
    return one_line(fmt::format("its program ended with status {}: {}", ended.status, last));
  }

  const RunFolder& run_;
  const LocalOptions& options_;
  std::vector<std::uint64_t> wanted_;
  std::vector<bool> ends_;
  std::mutex guard_;  // of all below
  std::vector<bool> over_;
  bool stopped_ = false;
  Tally tally_;
  Errors errors_;
};

}  // namespace

Tally tally_of(const RunFolder& run, const Results& results) {
  Tally tally;
  tally.shards = run.shards().size();
  for (std::uint64_t s = 0; s < tally.shards; ++s) {
    tally.minutes += run.minutes(s);
    if (!results.done[s]) continue;
    ++tally.done;
    tally.done_minutes += run.minutes(s);
    tally.failed += results.failed(s) ? 1 : 0;
  }
  tally.errors = results.errors.size();
  return tally;
}

Errors run_local(const RunFolder& run, const Kinds& kinds, const LocalOptions& options) {
  return Pool(run, kinds, options).work();
}

}  // namespace cosim::regress
