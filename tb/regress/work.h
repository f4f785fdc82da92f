// What a task of a plan comes to: works, each of which is cut by the numbers of its units.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tb/regress/plan.h"
#include "tb/sim/checkpoint.h"
#include "tb/util/json_at.h"
#include "tb/util/words.h"

namespace cosim::regress {

/// Where a part of a work is run.
struct Place {
  std::filesystem::path run;       ///< the run's folder
  std::filesystem::path prepared;  ///< where Work::prepare left what it made
  std::uint64_t shard = 0;
  Checkpoint& checkpoint;  ///< of this part alone

  /// Folders of failures stand in it.
  std::filesystem::path failures() const { return run / "failures"; }
};

/// What came of the units first to last - 1.
struct Part {
  std::uint64_t first = 0, last = 0;
  JsonAt result;  ///< of Work::run
  bool failed = false;

  std::uint64_t units() const { return last - first; }
};

/// Cases of a sweep, mutants, claims: units 0 to units - 1. What comes of a unit follows from its
/// number, the task and the program alone, and not from the units that it is run with.
class Work {
 public:
  /// What of `title` is not printable becomes "?".
  Work(std::string title, std::uint64_t units)
      : title_(one_line(std::move(title))), units_(units) {}
  virtual ~Work() = default;
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;

  /// One line, the same on every machine.
  const std::string& title() const { return title_; }
  /// >= 1
  std::uint64_t units() const { return units_; }
  /// Whether nothing after a unit that fails is looked at.
  virtual bool ends_at_failure() const { return false; }

  /// Makes what the parts need, in the folder `prepared`, which it makes if it needs one. A part
  /// that runs elsewhere, on a node of a cluster, finds no compiler and perhaps another processor.
  /// InputError where that cannot be done.
  virtual void prepare(const std::filesystem::path& /*prepared*/, bool /*elsewhere*/) const {}

  /// Runs the units first to last - 1, first < last. The result is an object without times and
  /// hosts; where something does not hold, it has `failed`, an array of objects with `what`, one
  /// line, and where there is one `folder`, in the run's folder, and `command`, the words behind
  /// the program that show it again, in the run's folder. Interrupted (interrupt.h) when a signal
  /// comes; then the checkpoint has what was done. InputError where it cannot be run.
  virtual Json run(std::uint64_t first, std::uint64_t last, const Place& place) const = 0;

  /// The results of all units in their order, put together: the same however they were cut. Behind
  /// a failure the later ones are missing where ends_at_failure(). `failed` in it, as of run():
  /// each part holds, and all together do not. InputError where a result is not of the units of its
  /// part.
  virtual Json merged(const std::vector<Part>& parts) const = 0;

 private:
  std::string title_;
  std::uint64_t units_;
};

using Works = std::vector<std::unique_ptr<Work>>;

/// A kind of task.
class Kind {
 public:
  virtual ~Kind() = default;
  virtual Keys keys() const = 0;
  /// What the task comes to, always in the same order. `folder`: that of the plan or of the run,
  /// from which the paths in it lead. InputError where it is nothing that can be done.
  virtual Works works(const Task& task, const std::filesystem::path& folder) const = 0;
  /// Copies the files that the task names from the plan's folder into that of the run, and names
  /// them there: what the run needs does not change any more. InputError where there are none.
  virtual void keep(Task& /*task*/, const std::filesystem::path& /*plan*/,
                    const std::filesystem::path& /*run*/) const {}
};

using Kinds = std::vector<std::unique_ptr<Kind>>;

/// That of the task.
const Kind& kind_of(const Kinds& kinds, const Task& task);

/// Their tables.
std::vector<Keys> keys_of(const Kinds& kinds);

}  // namespace cosim::regress
