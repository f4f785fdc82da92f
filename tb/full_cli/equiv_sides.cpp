#include "tb/full_cli/equiv_sides.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>

#include "model/core/input_error.h"
#include "tb/full_cli/revision.h"
#include "tb/new/liberty.h"
#include "tb/new/verilog_words.h"
#include "tb/program/named_values.h"
#include "tb/rtl/plain_verilog.h"
#include "tb/support/output_file.h"
#include "tb/support/parallel.h"
#include "tb/support/process.h"
#include "tb/support/read_file.h"
#include "tb/support/words.h"

namespace cosim::cli {
namespace {

// What is of both sides, as the old one had it.
SideFiles old_files(const EquivOptions& o, const std::filesystem::path& scratch) {
  namespace fs = std::filesystem;
  for (const std::string& file : o.files) {
    if (!fs::exists(file)) throw InputError(file + ": No such file or directory");
  }
  const Revision revision(*o.rev, o.files.front(), scratch);
  SideFiles old;
  for (const std::string& file : o.files) {
    if (const auto was = revision.old(file)) old.files.push_back(*was);
  }
  if (old.files.empty()) {
    throw InputError(fmt::format("--rev: {} has none of the files", in_quotes(*o.rev)));
  }
  const auto add = [&](std::vector<std::string>& to, const std::vector<std::string>& all) {
    for (const std::string& one : all) {
      if (const auto was = revision.old(one, true)) to.push_back(*was);
    }
  };
  add(old.cells, o.cells);
  add(old.include_dirs, o.include_dirs);
  if (const auto was = revision.old(".")) old.folder = *was;
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

struct Named {
  const char* what;
  const char* option;
  const Text& top;
  const std::vector<std::string>& parameters;
};

equiv::Side read_side(const EquivOptions& o, const SideFiles& own, const Named& named,
                      const std::filesystem::path& made, const equiv::Budget& budget) {
  equiv::Files all;
  all.top = named.top ? *named.top : needed("--top", o.top);
  std::vector<std::string> parameters = o.parameters;
  parameters.insert(parameters.end(), named.parameters.begin(), named.parameters.end());
  const char* const option = named.parameters.empty() ? "--param" : named.option;
  for (const auto& [name, value] : named_values(option, parameters, "NAME=VALUE")) {
    all.parameters.push_back(name + '=' + value);
  }
  named_values("--define", o.defines);
  all.defines = o.defines;
  all.include_dirs.assign(own.include_dirs.begin(), own.include_dirs.end());
  all.folder = own.folder;
  std::vector<std::string> verilog = own.files;
  verilog.insert(verilog.end(), own.cells.begin(), own.cells.end());
  // A file that is named twice, as by a pattern and itself, is one.
  std::set<std::filesystem::path> met;
  std::erase_if(verilog, [&](const std::string& file) {
    return !met.insert(std::filesystem::weakly_canonical(file)).second;
  });
  const std::filesystem::path cells = made.string() + ".cells";
  std::filesystem::create_directories(cells);
  std::filesystem::create_directory(made);
  read_cells(verilog, o.blackboxes, cells);
  if (std::ranges::all_of(verilog, rtl::is_vhdl)) all.vhdl.assign(verilog.begin(), verilog.end());
  const auto status_of = [](const auto& words) { return cosim::run_program(words).status; };
  try {
    const auto plain = rtl::plain_verilog(
        {".", verilog, all.top, all.parameters, o.blackboxes, true}, made, status_of);
    all.files.assign(plain.begin(), plain.end());
  } catch (const InputError& error) {
    require_room(made.parent_path());
    throw InputError(fmt::format("equiv: {}", error.what()));
  }
  return equiv::read(all, named.what, budget);
}

}  // namespace

BothFiles files_of(const EquivOptions& o, const std::filesystem::path& scratch) {
  BothFiles both;
  if (o.rev) {
    if (!o.gold.empty() || !o.gate.empty())
      throw InputError("--rev: does not go with --gold or --gate");
    if (o.files.empty()) throw InputError("FILE: is needed");
  } else if (!o.files.empty()) {
    throw InputError(fmt::format("equiv: takes no {} without --rev", in_quotes(o.files.front())));
  } else if (o.gold.empty()) {
    throw InputError("--gold: is needed, or --rev");
  } else if (o.gate.empty()) {
    throw InputError("--gate: is needed");
  }
  both.gate = {o.rev ? o.files : o.gate, o.cells, o.include_dirs};
  both.gold = o.rev ? old_files(o, scratch) : SideFiles{o.gold, o.cells, o.include_dirs};
  return both;
}

BothSides read_sides(const EquivOptions& o, const BothFiles& files,
                     const std::filesystem::path& folder, const equiv::Budget& budget,
                     unsigned jobs) {
  BothSides both;
  const Named gold{"the old RTL", "--param and --gold-param", o.gold_top, o.gold_parameters};
  const Named gate{"the new RTL", "--param and --gate-param", o.gate_top, o.gate_parameters};
  in_parallel(2, jobs, [&](std::uint64_t i) {
    if (i == 0) both.gold = read_side(o, files.gold, gold, folder / "was", budget);
    if (i == 1) both.gate = read_side(o, files.gate, gate, folder / "is", budget);
    return true;
  });
  return both;
}

}  // namespace cosim::cli
