#include "tb/new/new_sources.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "model/core/input_error.h"
#include "tb/new/verilog_words.h"
#include "tb/rtl/plain_verilog.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

struct Candidate {
  fs::path path;
  std::string text;
  VerilogText words;
  bool is_named = false;  // by a person, not found in a folder
  std::map<std::string, fs::path> headers = {};
};

bool is_rtl(const fs::path& file) {
  return file.extension() == ".v" || file.extension() == ".sv" || rtl::is_vhdl(file);
}

std::vector<fs::path> rtl_in(const fs::path& folder, bool below) {
  std::vector<fs::path> all;
  const auto add = [&](const fs::directory_entry& entry) {
    if (entry.is_regular_file() && is_rtl(entry.path())) all.push_back(entry.path());
  };
  if (below) {
    for (const auto& entry : fs::recursive_directory_iterator(folder)) add(entry);
  } else {
    for (const auto& entry : fs::directory_iterator(folder)) add(entry);
  }
  std::sort(all.begin(), all.end());
  return all;
}

class Pool {
 public:
  explicit Pool(const GivenRtl& given) {
    for (const std::string& file : given.files) {
      if (fs::is_directory(file)) {
        for (const fs::path& path : rtl_in(file, true)) add(path, false);
      } else {
        add(file, true);
      }
    }
    for (const std::string& folder : given.libraries) {
      if (fs::is_regular_file(folder)) {
        add(folder, false);
        continue;
      }
      if (!fs::is_directory(folder))
        throw InputError("-y: " + in_quotes(folder) + ": no such folder");
      for (const fs::path& path : rtl_in(folder, false)) add(path, false);
    }
    // A module that two files have is taken from the one of its name.
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (const VerilogUnit& unit : all[i].words.units) {
        if (unit.name.empty()) continue;
        const auto [known, is_new] = home.try_emplace(unit.name, i);
        const Candidate& other = all[known->second];
        if (!is_new && !other.is_named && all[i].path.stem() == unit.name &&
            other.path.stem() != unit.name) {
          known->second = i;
        }
      }
    }
  }

  std::vector<Candidate> all;
  std::map<std::string, std::size_t> home;  // of a module, a package, an interface

 private:
  void add(const fs::path& path, bool is_named) {
    std::string text = read_file(path.string());
    VerilogText words = rtl::is_vhdl(path) ? vhdl_words(text) : verilog_words(text);
    all.push_back({path, std::move(text), std::move(words), is_named});
  }
};

bool is_testbench(const VerilogText& text) {
  return text.units.size() > 1 &&
         std::all_of(text.units.begin() + 1, text.units.end(),
                     [](const VerilogUnit& unit) { return is_testbench(unit); });
}

// The module that no other has an instance of, testbenches aside; of several the one that these
// have, or, and then it `is_guessed`, the one that is called like the first file.
std::string top_of(const Pool& pool, const GivenRtl& given, bool& is_guessed) {
  if (!given.top.empty()) {
    const auto found = pool.home.find(given.top);
    if (found == pool.home.end())
      throw InputError("--top: no file has a module " + in_quotes(given.top));
    return given.top;
  }
  const bool any_named = std::ranges::any_of(pool.all, &Candidate::is_named);
  std::set<std::string> tops, used, tested;
  for (const Candidate& c : pool.all) {
    if (any_named && !c.is_named) continue;
    for (const VerilogUnit& unit : c.words.units) {
      if (unit.is_module) tops.insert(unit.name);
      if (is_testbench(unit)) used.insert(unit.name);
      const bool tests = is_testbench(unit) || is_testbench(c.words);
      for (const std::string& use : unit.uses) {
        if (use != unit.name) (tests ? tested : used).insert(use);
      }
    }
  }
  if (tops.empty()) throw InputError("no module in " + in_quotes(given.files.front()));
  std::set<std::string> all;
  for (const std::string& top : tops) {
    if (!used.contains(top)) all.insert(top);
  }
  if (all.contains(given.name)) return given.name;
  if (all.size() > 1) {
    std::set<std::string> some = all;
    std::erase_if(some, [&](const std::string& top) { return !tested.contains(top); });
    if (some.size() == 1) all = some;
  }
  if (all.size() == 1) return *all.begin();
  if (all.empty()) all = tops;
  const fs::path first = given.files.empty() ? "" : fs::path(given.files.front()).stem();
  if (all.contains(first.string())) {
    is_guessed = true;
    return first.string();
  }
  std::vector<std::string> some(
      all.begin(), std::next(all.begin(), std::min<std::ptrdiff_t>(8, std::ssize(all))));
  throw InputError(fmt::format("the top may be {}{}: choose it with --top", fmt::join(some, " or "),
                               all.size() > some.size() ? " or another" : ""));
}

// The files that one needs: a package behind those that it needs, then a module before those.
class Order {
 public:
  explicit Order(const Pool& pool) : pool_(pool) {}

  bool has(std::size_t i) const { return seen_.contains(i); }
  void need(std::size_t i) {
    if (!seen_.insert(i).second) return;
    const VerilogText& words = pool_.all[i].words;
    const bool has_package = std::ranges::any_of(words.units, &VerilogUnit::is_package);
    if (!has_package) modules.push_back(i);
    for (const VerilogUnit& unit : words.units) need_all(unit.uses);
    if (has_package) packages.push_back(i);
  }
  void need_all(const std::set<std::string>& uses) {
    for (const std::string& use : uses) {
      const auto found = pool_.home.find(use);
      if (found != pool_.home.end()) need(found->second);
    }
  }

  std::vector<std::size_t> packages, modules;

 private:
  const Pool& pool_;
  std::set<std::size_t> seen_;
};

// The folders that may have headers, beside those of the files that include them.
std::vector<fs::path> header_folders(const GivenRtl& given) {
  std::vector<fs::path> folders(given.includes.begin(), given.includes.end());
  folders.insert(folders.end(), given.libraries.begin(), given.libraries.end());
  for (const std::string& file : given.files) {
    if (!fs::is_directory(file)) continue;
    folders.emplace_back(file);
    for (const char* beside : {"include", "inc"}) folders.push_back(fs::path(file) / ".." / beside);
    for (const auto& entry : fs::recursive_directory_iterator(file)) {
      if (entry.is_directory()) folders.push_back(entry.path());
    }
  }
  return folders;
}

// Finds all headers of a file, and what they use: they are read with it. One that is nowhere may
// be one that is not asked for.
void find_headers(Candidate& c, const std::vector<fs::path>& folders) {
  std::vector<std::pair<std::string, fs::path>> left;
  for (const std::string& name : c.words.headers) left.emplace_back(name, c.path);
  while (!left.empty()) {
    const auto [name, includer] = left.back();
    left.pop_back();
    std::vector<fs::path> places{includer.parent_path()};
    places.insert(places.end(), folders.begin(), folders.end());
    const auto place = std::ranges::find_if(
        places, [&n = name](const fs::path& folder) { return fs::is_regular_file(folder / n); });
    if (place == places.end() || !c.headers.try_emplace(name, *place / name).second) continue;
    const VerilogText words = verilog_words(read_file((*place / name).string()));
    for (const VerilogUnit& unit : words.units) {
      c.words.units.front().uses.insert(unit.uses.begin(), unit.uses.end());
    }
    for (const std::string& more : words.headers) left.emplace_back(more, *place / name);
  }
}

}  // namespace

Sources sources_of(const GivenRtl& given) {
  for (const std::string& folder : given.includes) {
    if (!fs::is_directory(folder))
      throw InputError("--include: " + in_quotes(folder) + ": no such folder");
  }
  Pool pool(given);
  Sources sources;
  sources.top = top_of(pool, given, sources.top_is_guessed);
  const std::vector<fs::path> folders = header_folders(given);
  for (Candidate& c : pool.all) find_headers(c, folders);
  Order order(pool);
  order.need(pool.home.at(sources.top));
  order.need_all(given.uses);
  for (std::size_t i = 0; i < pool.all.size(); ++i) {
    if (!pool.all[i].is_named || order.has(i)) continue;
    if (is_testbench(pool.all[i].words)) {
      sources.left_out.push_back(pool.all[i].path.filename().string());
    } else {
      order.need(i);
    }
  }
  std::set<std::string> included;
  std::vector<std::size_t> chosen = order.packages;
  if (order.packages.empty() && std::ranges::all_of(pool.all, &Candidate::is_named)) {
    for (std::size_t i = 0; i < pool.all.size(); ++i) {
      if (order.has(i)) chosen.push_back(i);  // as they were typed
    }
  } else {
    chosen.insert(chosen.end(), order.modules.begin(), order.modules.end());
  }
  // A file that declares nothing has macros for all others.
  std::stable_partition(chosen.begin(), chosen.end(), [&](std::size_t i) {
    const auto& units = pool.all[i].words.units;
    return units.size() == 1 && std::ranges::none_of(units.front().uses, [&](const auto& use) {
             return pool.home.contains(use);
           });
  });
  for (const std::size_t i : chosen) {
    Candidate& c = pool.all[i];
    sources.files.push_back({c.path.filename().string(), c.path, c.text});
    for (const auto& [name, path] : c.headers) {
      if (included.insert(name).second)
        sources.headers.push_back({name, path, read_file(path.string())});
    }
  }
  return sources;
}

void require_homes(const Sources& sources, const std::vector<std::string>& named) {
  std::map<std::string, const SourceFile*> home;
  for (const SourceFile& file : sources.files) {
    if (std::ranges::find(named, file.from.string()) == named.end()) continue;
    if (file.text.find("`if") != std::string::npos) continue;  // it may be for another tool
    for (const VerilogUnit& unit : verilog_words(file.text).units) {
      const auto [other, is_new] = home.try_emplace(unit.name, &file);
      if (is_new || unit.name.empty() || other->second == &file) continue;
      throw InputError(fmt::format("new: {} and {}: {} is in both",
                                   in_quotes(other->second->from.string()),
                                   in_quotes(file.from.string()), unit.name));
    }
  }
}

std::vector<std::string> in_order(std::vector<std::string> files) {
  const Pool pool({.name = "", .files = files});
  Order order(pool);
  for (std::size_t i = 0; i < files.size(); ++i) order.need(i);
  const auto uses_one_behind = [&](std::size_t i) {
    return std::ranges::any_of(pool.all[i].words.units, [&](const VerilogUnit& unit) {
      return std::ranges::any_of(order.packages, [&](std::size_t package) {
        const auto& all = pool.all[package].words.units;
        return package > i && std::ranges::any_of(all, [&](const VerilogUnit& one) {
                 return one.is_package && unit.uses.contains(one.name);
               });
      });
    });
  };
  std::vector<std::size_t> places = order.packages;
  bool is_needed = false;
  for (std::size_t i = 0; i < files.size(); ++i) {
    is_needed = is_needed || uses_one_behind(i);
    if (std::ranges::find(order.packages, i) == order.packages.end()) places.push_back(i);
  }
  if (!is_needed) return files;
  std::vector<std::string> sorted;
  for (const std::size_t place : places) sorted.push_back(files[place]);
  return sorted;
}

}  // namespace cosim::cli
