// The folder of a run: all that a host needs, and all that came of it.
//
//   run.json     what the run is made of, and the hashes of program and plan; written last
//   plan.json    the plan, with every seed
//   PROGRAM      the program, so that a new build does not change the run
//   files/       the files that the plan names
//   prepared/    what was made for the shards before the first of them
//   results/     lines of JSON (results.h)
//   checkpoints/ of shards that are under way
//   failures/    a folder for each failure, ready for `replay`
//   logs/        what the shards' programs said, on a cluster
//   report.json, report.txt   what came of it; times.json: when, where and how long
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tb/regress/plan.h"
#include "tb/regress/work.h"

namespace cosim::regress {

/// A work as far as it is cut.
struct Size {
  std::uint64_t units = 0;  ///< >= 1
  double minutes = 0;       ///< that it is thought to take, > 0
};

/// Units first to last - 1 of a work.
struct Shard {
  std::size_t work = 0;
  std::uint64_t first = 0, last = 0;
};

/// The most shards of a run.
inline constexpr std::uint64_t most_shards = 1'000'000;

/// As many as give each a minute, at most most_shards.
std::uint64_t usual_shards(const std::vector<Size>& works);

/// About `shards` shards in the order of the works and of their units, each work in equal parts: by
/// the time it is thought to take, at least one each, and none without a unit.
std::vector<Shard> cut(const std::vector<Size>& works, std::uint64_t shards);

/// A work as the run knows it without making it.
struct Known {
  std::size_t task = 0, in_task = 0;  ///< number of the task, and in it
  std::string title;
  Size size;
};

class RunFolder {
 public:
  /// Makes a folder for the plan, whose paths lead from `plan_folder`, cut into about `shards`
  /// shards, and has every work prepared, also for other machines where it runs `elsewhere`.
  /// InputError where something is there already, or where it cannot be done; then nothing is left.
  static RunFolder make(const std::filesystem::path& folder, Plan plan, const Kinds& kinds,
                        const std::filesystem::path& plan_folder, std::uint64_t shards,
                        bool elsewhere);

  /// That of a run that was made. InputError where it is none, where its plan or run.json has been
  /// changed, and where this is another program than that of the run.
  RunFolder(const std::filesystem::path& folder, const Kinds& kinds);

  const std::filesystem::path& path() const { return path_; }
  const Plan& plan() const { return plan_; }
  const std::vector<Known>& works() const { return works_; }
  const std::vector<Shard>& shards() const { return shards_; }
  /// The copy that runs the shards.
  std::filesystem::path program() const;
  std::filesystem::path prepared(std::size_t work) const;
  /// What a shard is thought to take, in minutes.
  double minutes(std::uint64_t shard) const;
  /// Works, made anew: those of one task. InputError where they are not as the run knows them.
  Works works_of(std::size_t task, const Kinds& kinds) const;

  /// The hash of program, plan and works, a word: what checkpoints and results are of.
  const std::string& identity() const { return identity_; }

 private:
  RunFolder() = default;

  std::filesystem::path path_;
  Plan plan_;
  std::vector<Known> works_;
  std::vector<Shard> shards_;
  std::string identity_;
};

/// What the works of the plan are. What is wrong is added to `errors`, with `path` and the place.
std::vector<Known> known_works(const Plan& plan, const Kinds& kinds,
                               const std::filesystem::path& folder, const std::string& path,
                               std::vector<std::string>& errors);

/// Their sizes.
std::vector<Size> sizes(const std::vector<Known>& works);

}  // namespace cosim::regress
