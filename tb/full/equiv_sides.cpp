#include "tb/full/equiv_sides.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>

#include "model/core/input_error.h"
#include "tb/cli/named_values.h"
#include "tb/full/wrapped_top.h"
#include "tb/new/liberty.h"
#include "tb/new/new_sources.h"
#include "tb/new/verilog_words.h"
#include "tb/rtl/file_list.h"
#include "tb/rtl/plain_verilog.h"
#include "tb/util/output_file.h"
#include "tb/util/parallel.h"
#include "tb/util/pattern.h"
#include "tb/util/process.h"
#include "tb/util/read_file.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

std::vector<std::string> with(std::vector<std::string> all, const std::vector<std::string>& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

// Files, some of which may be lists, and with `both` what the options name of both sides. `file_at`
// is for files that no list names.
rtl::FileList listed(const EquivOptions& o, const std::vector<std::string>& files, bool both,
                     const rtl::Place& file_at, const rtl::Place& place) {
  rtl::FileList all;
  for (const std::string& file : files) {
    if (rtl::is_file_list(file)) {
      rtl::read_file_list(file, true, place, all);
    } else if (const auto at = file_at(file)) {
      all.files.push_back(*at);
    }
  }
  if (!both) return all;
  for (const std::string& list : o.lists) rtl::read_file_list(list, false, place, all);
  for (const std::string& list : o.own_lists) rtl::read_file_list(list, true, place, all);
  return all;
}

SideFiles side_of(const rtl::FileList& list, const EquivOptions& o) {
  SideFiles side{list.files, {}, {}, {}, list.libraries};
  side.defines = rtl::with_defines(list.defines, o.defines);
  return side;
}

SideFiles new_files(const EquivOptions& o, const std::vector<std::string>& files, bool both) {
  // A file that is not there is named where it is read.
  const auto as_typed = [](const std::filesystem::path& file) { return file.string(); };
  const rtl::FileList list = listed(o, files, both, as_typed, rtl::place_today);
  SideFiles side = side_of(list, o);
  side.cells = o.cells;
  side.include_dirs = with(o.include_dirs, list.include_dirs);
  return side;
}

// What is of both sides, as the old one had it.
SideFiles old_files(const EquivOptions& o, const std::filesystem::path& scratch) {
  namespace fs = std::filesystem;
  const std::vector<std::string> named = with(with(o.files, o.lists), o.own_lists);
  for (const std::string& file : named) {
    if (!fs::exists(file)) throw InputError(file + ": No such file or directory");
  }
  const Revision revision(*o.rev, named, scratch);
  for (const std::string& file : named) {
    if (revision.has(file)) continue;
    fmt::print("{}: in another repository: as it is today on both sides\n", one_line(file));
  }
  for (const std::string& list : with(o.lists, o.own_lists)) {
    if (revision.old(list)) continue;
    throw InputError(fmt::format("--rev: {} has no list of files {}", in_quotes(*o.rev), list));
  }
  const auto was = [&](const fs::path& path) { return revision.old(path); };
  const rtl::FileList list = listed(o, o.files, true, was, was);
  SideFiles old = side_of(list, o);
  if (old.files.empty()) {
    throw InputError(fmt::format("--rev: {} has none of the files", in_quotes(*o.rev)));
  }
  const auto add = [&](std::vector<std::string>& to, const std::vector<std::string>& all) {
    for (const std::string& one : all) {
      if (const auto at = revision.old(one, true)) to.push_back(*at);
    }
  };
  add(old.cells, o.cells);
  add(old.include_dirs, o.include_dirs);
  old.include_dirs = with(old.include_dirs, list.include_dirs);
  if (const auto folder = was(".")) old.folder = *folder;
  return old;
}

// Verilog in place of files of Liberty, in `folder`.
void read_cells(std::vector<std::string>& files, const std::vector<std::string>& blackboxes,
                const std::filesystem::path& folder) {
  std::map<std::string, std::string> left_out;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!is_liberty(files[i])) continue;
    const LibertyCells cells = cells_of(read_file(files[i]), files[i]);
    for (const auto& [name, why] : cells.left_out) {
      left_out[name] = fmt::format("{}: cell {}: {}", files[i], name, why);
    }
    files[i] = (folder / fmt::format("cells{}.v", i)).string();
    write_file(files[i], cells.verilog);
  }
  if (left_out.empty()) return;
  for (const std::string& file : files) {
    for (const VerilogUnit& unit : verilog_words(read_file(file)).units) {
      for (const auto& [name, why] : left_out) {
        if (!unit.uses.contains(name) || std::ranges::find(blackboxes, name) != blackboxes.end()) {
          continue;
        }
        throw InputError(fmt::format("{}; {} has an instance of it: --blackbox {}", why,
                                     unit.name.empty() ? file : unit.name, name));
      }
    }
  }
}

// A module around the top, as `cosim new` writes it, where that has ports that are interfaces or is
// given types as parameters.
void wrap_top(equiv::Files& all, std::vector<std::string>& files,
              const std::filesystem::path& folder) {
  Sources rtl;
  rtl.top = all.top;
  for (const std::string& file : files) {
    const std::filesystem::path path = std::filesystem::absolute(file);
    if (path.extension() == ".sv") rtl.files.push_back({path.string(), path, read_file(file)});
  }
  if (!needs_wrapper(all.parameters, rtl)) return;
  RtlQuestion asked;
  asked.folder = folder;
  for (const auto& dir : all.include_dirs)
    asked.options.push_back("-I" + std::filesystem::absolute(dir).string());
  for (const std::string& define : all.defines) asked.options.push_back("-D" + define);
  std::set<std::string> left;
  for (const FoundParameter& p : with_wrapper(all.top, all.parameters, rtl, asked))
    left.insert(p.name);
  std::erase_if(all.parameters, [&](const std::string& word) {
    return !left.contains(word.substr(0, word.find('=')));
  });
  all.top = rtl.top;
  files.push_back((folder / rtl.files.back().name).string());
  write_file(files.back(), rtl.files.back().text);
}

struct Named {
  const char* what;
  const char* option;
  const Text& top;
  const std::vector<std::string>& parameters;
};

// What a front end says of a top or a parameter that is not there, with the option that gives it.
std::string in_our_words(const std::string& error, const EquivOptions& o, const Named& named,
                         const std::string& top, const char* option) {
  static const Pattern parameter("a parameter is given that no module has: ([^ ]+)$");
  if (error.ends_with("no file has the module " + top)) {
    const char* const own = named.what == std::string("the old RTL") ? "--gold-top" : "--gate-top";
    return named.top
               ? fmt::format("{}: no file of {} has a module {}", own, named.what, in_quotes(top))
           : o.top ? fmt::format("--top: no file of {} has a module {}", named.what, in_quotes(top))
                   : fmt::format("{}: no file has a module {}: {} names its top", named.what,
                                 in_quotes(top), own);
  }
  const auto found = parameter.all(error);
  return found.empty() ? error
                       : fmt::format("{}: {} has no parameter {}", option, top, found[0][1]);
}

equiv::Side read_side(const EquivOptions& o, const SideFiles& own, const Named& named,
                      const std::string& top, const std::filesystem::path& made,
                      const equiv::Budget& budget) {
  equiv::Files all;
  all.top = named.top.value_or(top);
  std::vector<std::string> parameters = o.parameters;
  parameters.insert(parameters.end(), named.parameters.begin(), named.parameters.end());
  const char* const option = named.parameters.empty() ? "--param" : named.option;
  for (const auto& [name, value] : named_values(option, parameters, "NAME=VALUE")) {
    all.parameters.push_back(name + '=' + value);
  }
  all.defines = own.defines;
  all.include_dirs.assign(own.include_dirs.begin(), own.include_dirs.end());
  all.folder = own.folder;
  std::vector<std::string> verilog = own.files;
  if (!own.libraries.empty()) {
    verilog.clear();
    const Sources needed =
        sources_of({all.top, own.files, own.libraries, own.include_dirs, all.top});
    for (const SourceFile& file : needed.files) verilog.push_back(file.from.string());
  } else {
    verilog = in_order(std::move(verilog));
  }
  verilog = with(verilog, own.cells);
  // A file that is named twice, as by a pattern and itself, is one.
  std::set<std::filesystem::path> met;
  std::erase_if(verilog, [&](const std::string& file) {
    return !met.insert(std::filesystem::weakly_canonical(file)).second;
  });
  const std::filesystem::path cells = made.string() + ".cells";
  std::filesystem::create_directories(cells);
  std::filesystem::create_directory(made);
  read_cells(verilog, o.blackboxes, cells);
  wrap_top(all, verilog, cells);
  if (std::ranges::all_of(verilog, rtl::is_vhdl)) all.vhdl.assign(verilog.begin(), verilog.end());
  const auto run = [](const auto& words) {
    Ended ended = cosim::run_program(words);
    return rtl::Ran{ended.status, std::move(ended.text)};
  };
  try {
    const auto plain =
        rtl::plain_verilog({".", verilog, all.top, all.parameters, o.blackboxes, true}, made, run);
    all.files.assign(plain.begin(), plain.end());
  } catch (const InputError& error) {
    require_room(made.parent_path());
    throw InputError(fmt::format("equiv: {}", error.what()));
  }
  try {
    return equiv::read(all, named.what, budget);
  } catch (const InputError& error) {
    throw InputError(in_our_words(error.what(), o, named, all.top, option));
  }
}

}  // namespace

BothFiles files_of(const EquivOptions& o, const std::filesystem::path& scratch) {
  BothFiles both;
  if (o.rev) {
    if (!o.gold.empty() || !o.gate.empty())
      throw InputError("--rev: does not go with --gold or --gate");
    if (o.files.empty() && o.lists.empty() && o.own_lists.empty()) {
      throw InputError("FILE: is needed, or -f LIST");
    }
  } else if (!o.files.empty()) {
    if (o.files.size() != 2 || !o.gold.empty() || !o.gate.empty()) {
      throw InputError(
          "equiv: takes the old file and the new one, or --gold FILES --gate FILES, or --rev");
    }
  } else if (o.gold.empty()) {
    throw InputError("--gold: is needed, or OLD NEW, or --rev");
  } else if (o.gate.empty()) {
    throw InputError("--gate: is needed");
  }
  named_values("--define", o.defines);
  const bool is_one_list = o.rev.has_value();
  if (!is_one_list && !(o.lists.empty() && o.own_lists.empty())) {
    throw InputError("-f and -F: go with --rev; --gold and --gate take a list as FILE.f");
  }
  const bool is_pair = !o.rev && !o.files.empty();
  const std::vector<std::string> now = is_pair ? std::vector{o.files[1]} : o.rev ? o.files : o.gate;
  both.gate = new_files(o, now, is_one_list);
  both.gold = o.rev ? old_files(o, scratch)
                    : new_files(o, is_pair ? std::vector{o.files[0]} : o.gold, false);
  return both;
}

std::string top_of(const EquivOptions& o, const SideFiles& gate) {
  if (o.top) return *o.top;
  if (o.gate_top) return *o.gate_top;
  const Sources sources =
      sources_of({.name = "", .files = gate.files, .includes = gate.include_dirs});
  if (!sources.top_is_guessed) return sources.top;
  throw InputError(fmt::format(
      "--top: is needed: {} is not the only module that no other has an instance of", sources.top));
}

std::vector<std::string> files_named(const EquivOptions& o) {
  std::vector<std::string> all = o.cells;
  const auto as_typed = [](const std::filesystem::path& file) { return file.string(); };
  for (const auto* files : {&o.gold, &o.gate, &o.files}) {
    all = with(all, *files);
    try {
      const rtl::FileList list = listed(o, *files, files == &o.files, as_typed, rtl::place_today);
      all = with(with(all, list.files), list.lists);
    } catch (const InputError&) {
      continue;
    }
  }
  return all;
}

BothSides read_sides(const EquivOptions& o, const BothFiles& files, const std::string& top,
                     const std::filesystem::path& folder, const equiv::Budget& budget,
                     unsigned jobs) {
  BothSides both;
  const Named gold{"the old RTL", "--param and --gold-param", o.gold_top, o.gold_parameters};
  const Named gate{"the new RTL", "--param and --gate-param", o.gate_top, o.gate_parameters};
  in_parallel(2, jobs, [&](std::uint64_t i) {
    if (i == 0) both.gold = read_side(o, files.gold, gold, top, folder / "was", budget);
    if (i == 1) both.gate = read_side(o, files.gate, gate, top, folder / "is", budget);
    return true;
  });
  return both;
}

}  // namespace cosim::cli
