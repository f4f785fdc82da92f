#include "tb/regress/run_folder.h"

#include <fmt/core.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "model/core/input_error.h"
#include "tb/util/hash.h"
#include "tb/util/json.h"
#include "tb/util/json_at.h"
#include "tb/util/output_file.h"
#include "tb/util/parallel.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::regress {
namespace {

namespace fs = std::filesystem;

// Absolute, without a '/' behind it.
fs::path plain(const fs::path& folder) {
  const fs::path path = fs::absolute(folder).lexically_normal();
  return path.has_filename() ? path : path.parent_path();
}

[[noreturn]] void cannot_write(const fs::path& path, const std::error_code& error) {
  throw InputError(fmt::format("{}: cannot write: {}", path.string(), error.message()));
}

void make_folder(const fs::path& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) cannot_write(path, error);
}

// Removed unless it is kept. The folder itself was made by nobody else.
class New {
 public:
  explicit New(const fs::path& path) : path_(path) {
    std::error_code error;
    if (fs::exists(path, error)) throw InputError(path.string() + ": already exists");
    make_folder(path);
  }
  ~New() {
    std::error_code ignored;
    if (!kept_) fs::remove_all(path_, ignored);
  }
  New(const New&) = delete;
  New& operator=(const New&) = delete;
  void keep() { kept_ = true; }

 private:
  fs::path path_;
  bool kept_ = false;
};

Json to_json(const std::vector<Known>& works) {
  Json all = Json::array();
  for (const Known& w : works) {
    all.push_back({{"task", w.task},
                   {"in_task", w.in_task},
                   {"title", w.title},
                   {"units", w.size.units},
                   {"minutes", w.size.minutes}});
  }
  return all;
}

// Every work of every task of the plan, in order.
std::vector<Known> works_from(const JsonAt& json, const Plan& plan) {
  constexpr double least_minutes = 1e-9, most_minutes = 1e9;
  std::vector<Known> works;
  for (const JsonAt& w : json.list(1)) {
    const bool is_next = works.empty() || w.at("task").whole() != works.back().task;
    const std::size_t task = works.empty() ? 0 : works.back().task + (is_next ? 1 : 0);
    const std::size_t in_task = is_next ? 0 : works.back().in_task + 1;
    works.push_back(
        {w.at("task").whole(task, task),
         w.at("in_task").whole(in_task, in_task),
         w.at("title").text(),
         {w.at("units").whole(1), w.at("minutes").number(least_minutes, most_minutes)}});
  }
  if (works.back().task + 1 != plan.tasks.size()) json.fail("are not those of every task");
  return works;
}

void copy_program(const fs::path& to) {
  std::error_code error;
  fs::copy_file("/proc/self/exe", to, error);
  if (error) cannot_write(to, error);
}

}  // namespace

std::vector<Known> known_works(const Plan& plan, const Kinds& kinds, const fs::path& folder,
                               const std::string& path, std::vector<std::string>& errors) {
  std::vector<Known> all;
  for (std::size_t t = 0; t < plan.tasks.size(); ++t) {
    const Task& task = plan.tasks[t];
    try {
      const Works works = kind_of(kinds, task).works(task, folder);
      double units = 0;
      for (const auto& work : works) units += static_cast<double>(work->units());
      for (std::size_t i = 0; i < works.size(); ++i) {
        const std::uint64_t own = works[i]->units();
        all.push_back(
            {t, i, works[i]->title(), {own, task.minutes * static_cast<double>(own) / units}});
      }
    } catch (const InputError& error) {
      errors.push_back(one_line(fmt::format("{}: {}: {}", path, task.place, error.what())));
    }
  }
  return all;
}

std::vector<Size> sizes(const std::vector<Known>& works) {
  std::vector<Size> all;
  for (const Known& w : works) all.push_back(w.size);
  return all;
}

RunFolder RunFolder::make(const fs::path& folder, Plan plan, const Kinds& kinds,
                          const fs::path& plan_folder, std::uint64_t shards, bool elsewhere) {
  RunFolder run;
  run.path_ = plain(folder);
  New made(run.path_);
  for (const char* part : {"results", "checkpoints", "failures", "logs", "files", "prepared"}) {
    make_folder(run.path_ / part);
  }
  for (Task& task : plan.tasks) kind_of(kinds, task).keep(task, plan_folder, run.path_);
  run.plan_ = std::move(plan);
  std::vector<std::string> errors;
  run.works_ = known_works(run.plan_, kinds, run.path_, run.path_.string(), errors);
  if (!errors.empty()) throw InputError(errors.front());
  run.shards_ = cut(sizes(run.works_), shards);

  std::vector<Works> works;
  for (std::size_t t = 0; t < run.plan_.tasks.size(); ++t) works.push_back(run.works_of(t, kinds));
  in_parallel(run.works_.size(), cores(), [&](std::uint64_t i) {
    works[run.works_[i].task][run.works_[i].in_task]->prepare(run.prepared(i), elsewhere);
    return true;
  });

  copy_program(run.program());
  const std::string text = json_text(regress::to_json(run.plan_), 1) + '\n';
  write_file((run.path_ / "plan.json").string(), text);
  Json json{{"format", format},
            {"program", program_hash()},
            {"plan", hash_of(text)},
            {"shards", shards},
            {"works", to_json(run.works_)}};
  json["hash"] = hash_of(json_text(json));
  write_file((run.path_ / "run.json").string(), json_text(json, 1) + '\n');
  made.keep();
  return {run.path_, kinds};
}

RunFolder::RunFolder(const fs::path& folder, const Kinds& kinds) : path_(plain(folder)) {
  const std::string name = (path_ / "run.json").string();
  if (!fs::exists(name)) throw InputError(path_.string() + ": is not the folder of a regression");
  const JsonAt all(name, read_file(name));
  all.at("format").whole(format, format);
  const std::string text = read_file((path_ / "plan.json").string());
  if (all.at("program").text() != program_hash()) {
    throw InputError(
        fmt::format("{}: a run of another program or build; resume it with its own, {}",
                    path_.string(), program().string()));
  }
  if (all.at("plan").text() != hash_of(text)) {
    throw InputError(path_.string() + ": its plan.json was changed");
  }
  Json json = all.json();
  json.erase("hash");
  identity_ = all.at("hash").text();
  if (identity_ != hash_of(json_text(json))) throw InputError(name + ": was changed");
  std::vector<std::string> errors;
  plan_ = read_plan(text, (path_ / "plan.json").string(), keys_of(kinds), 0, errors);
  if (!errors.empty()) throw InputError(errors.front());
  works_ = works_from(all.at("works"), plan_);
  shards_ = cut(sizes(works_), all.at("shards").whole(1, most_shards));
}

fs::path RunFolder::program() const { return path_ / program_name(); }

fs::path RunFolder::prepared(std::size_t work) const {
  return path_ / "prepared" / std::to_string(work);
}

double RunFolder::minutes(std::uint64_t shard) const {
  const Shard& s = shards_[shard];
  const Size& size = works_[s.work].size;
  return size.minutes * static_cast<double>(s.last - s.first) / static_cast<double>(size.units);
}

Works RunFolder::works_of(std::size_t task, const Kinds& kinds) const {
  Works works = kind_of(kinds, plan_.tasks[task]).works(plan_.tasks[task], path_);
  auto known = std::ranges::find(works_, task, &Known::task);
  bool same = true;
  for (const auto& work : works) {
    same = same && known != works_.end() && known->task == task && known->title == work->title() &&
           known->size.units == work->units();
    if (same) ++known;
  }
  if (same && (known == works_.end() || known->task != task)) return works;
  throw InputError(fmt::format("{}: task {} is divided into other work on this host",
                               (path_ / "run.json").string(), in_quotes(plan_.tasks[task].name)));
}

}  // namespace cosim::regress
