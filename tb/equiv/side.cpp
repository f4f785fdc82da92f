#include "tb/equiv/side.h"

#include <fmt/core.h>

#include <algorithm>

#include "model/core/input_error.h"
#include "tb/equiv/netlist.h"
#include "tb/equiv/prints.h"
#include "tb/support/json.h"
#include "tb/support/output_file.h"
#include "tb/support/pattern.h"
#include "tb/support/quoted.h"
#include "tb/support/read_file.h"
#include "tb/support/words.h"

namespace cosim::equiv {
namespace {

namespace fs = std::filesystem;
using Lit = proof::Aig::Lit;

// A folder as the script calls it.
std::string linked(const fs::path& folder, const fs::path& scratch, int& n) {
  const fs::path name = scratch / fmt::format("folder{}", n++);
  fs::create_directory_symlink(fs::absolute(folder), name);
  return word_for_yosys(name.string());
}

// What goes to yosys is in a script, and folders have names of ours there: nothing that a person
// types is read as a command. A file stands in its own folder, where $readmemh looks for others;
// but without what it prints it is a copy, and so are the names in `scratch`, which must be new.
std::string reading(const Files& files, const fs::path& scratch, const fs::path& answers,
                    bool as_they_are) {
  std::string options = " -defer -D SYNTHESIS", commands;
  int n = 0;
  std::map<fs::path, std::string> folders;
  for (const fs::path& file : files.files) {
    const auto [at, is_new] = folders.try_emplace(fs::absolute(file).parent_path());
    if (is_new) at->second = linked(at->first, scratch, n);
  }
  for (const auto& [folder, link] : folders) options += " -I" + link;
  for (const fs::path& folder : files.include_dirs) options += " -I" + linked(folder, scratch, n);
  for (const std::string& define : files.defines) {
    static const Pattern good(R"([A-Za-z_]\w*(=[\w']+)?)");
    if (good.whole(define).empty()) {
      throw InputError(fmt::format("--define: {} is not NAME or NAME=VALUE", in_quotes(define)));
    }
    options += " -D" + define;
  }
  for (std::size_t i = 0; i < files.files.size(); ++i) {
    static const Pattern plain(R"([\w.+-]+)");
    std::string file = files.files[i].filename().string();
    if (!as_they_are) {
      write_file((scratch / fmt::format("file{}.v", i)).string(),
                 without_prints(read_file(files.files[i].string())));
      file = word_for_yosys((scratch / fmt::format("file{}.v", i)).string());
    } else if (plain.whole(file).empty()) {
      file = fmt::format("file{}.v", i);
      fs::create_symlink(fs::absolute(files.files[i]), scratch / file);
      file = word_for_yosys((scratch / file).string());
    } else {
      file.insert(0, folders.at(fs::absolute(files.files[i]).parent_path()) + '/');
    }
    const bool is_system_verilog = files.files[i].extension() == ".sv";
    commands +=
        fmt::format("read_verilog{}{} {}\n", is_system_verilog ? " -sv" : "", options, file);
  }
  commands += "hierarchy -check -top " + files.top;
  for (const std::string& parameter : files.parameters) {
    static const Pattern good(R"(([A-Za-z_][\w$]*)=([\w']+|"\w*"))");
    const Pattern::Parts part = good.whole(parameter);
    if (part.empty()) {
      throw InputError(fmt::format("--param: {} is not NAME=VALUE", in_quotes(parameter)));
    }
    commands += fmt::format(" -chparam {} {}", part[1], part[2]);
  }
  const std::string own = word_for_yosys(answers.string());
  return commands +
         fmt::format(
             "\nproc; check; setundef -undriven -anyseq; flatten; opt_clean; memory_collect\n"
             "opt_clean; write_json {0}/top.json; write_rtlil {0}/top.il\n",
             own);
}

// The line of the error, with the files by their own names.
std::string error_of(std::string text, const Files& files, const fs::path& scratch) {
  const std::size_t at = std::min(text.find("ERROR"), text.size());
  const std::size_t newline = text.rfind('\n', at);
  text = text.substr(newline == std::string::npos ? 0 : newline + 1);
  text.resize(std::min(text.find('\n'), text.size()));
  const auto replace = [&](const std::string& old, const std::string& by) {
    for (std::size_t p = 0; (p = text.find(old, p)) != std::string::npos; p += by.size()) {
      text.replace(p, old.size(), by);
    }
  };
  for (std::size_t i = files.files.size(); i-- > 0;) {
    replace((scratch / fmt::format("file{}.v", i)).string(), files.files[i].string());
    for (const auto& folder : fs::directory_iterator(scratch)) {
      const std::string name = files.files[i].filename().string();
      replace((folder.path() / name).string(), files.files[i].string());
    }
  }
  static const Pattern missing(
      R"(.*Module `\\(\S+)' referenced in .* is not part of the design.*)");
  if (const Pattern::Parts part = missing.whole(text); !part.empty()) {
    text += fmt::format(" Give a file that has it, or --blackbox {}", part[1]);
  }
  return one_line(text);
}

// "signed [7:4]", or nothing for a plain bit.
std::string declaration(const Json& port) {
  const auto width = static_cast<int>(port.at("bits").size());
  const int low = port.value("offset", 0);
  const bool rises = port.value("upto", 0) != 0;
  std::string text = port.value("signed", 0) != 0 ? "signed " : "";
  if (width > 1 || low != 0) {
    text += rises ? fmt::format("[{}:{}]", low, low + width - 1)
                  : fmt::format("[{}:{}]", low + width - 1, low);
  }
  return text;
}

// Whether it is part of what a memory is, and is the same in one that can take its place. How it is
// written is told by what comes of it, and a mask that is empty has as many bits as there are
// ports.
bool is_of_shape(const std::string& name, const std::string& value) {
  if (name == "WR_WIDE_CONTINUATION" || name == "RD_TRANSPARENCY_MASK" ||
      name == "RD_COLLISION_X_MASK") {
    return value.find('1') != std::string::npos;
  }
  return name != "MEMID" && !name.starts_with("WR_");
}

// Whether an input of one bit goes anywhere else than to the clocks of registers and memories.
bool is_read(const Json& module, const Json& bit) {
  const auto has = [&](const Json& bits) {
    return std::find(bits.begin(), bits.end(), bit) != bits.end();
  };
  for (const auto& [port, about] : module.at("ports").items()) {
    if (about.at("direction") != "input" && has(about.at("bits"))) return true;
  }
  static const std::set<std::string> clocks{"CLK", "WR_CLK", "RD_CLK"};
  for (const auto& [name, cell] : module.at("cells").items()) {
    for (const auto& [pin, bits] : cell.at("connections").items()) {
      if (!clocks.contains(pin) && has(bits)) return true;
    }
  }
  return false;
}

int whole_number(const Json& parameter) {
  return static_cast<int>(std::stoul(parameter.get<std::string>(), nullptr, 2));
}

}  // namespace

Side::Side(const Files& files, std::string what, const Budget& budget)
    : files_(files), what_(std::move(what)), scratch_(std::make_shared<const Scratch>()) {
  static const Pattern name(R"([A-Za-z_][\w$]*)");
  if (name.whole(files.top).empty()) {
    throw InputError(fmt::format("--top: {} is no name of Verilog", in_quotes(files.top)));
  }
  for (const fs::path& file : files.files) read_file(file.string());
  for (const fs::path& folder : files.include_dirs) {
    if (!fs::is_directory(folder)) {
      throw InputError(fmt::format("--include: {} is no folder", in_quotes(folder.string())));
    }
  }
  const fs::path own = scratch_->path(), again = own / "again";
  std::string said;
  try {
    said = yosys(reading(files, own, own, true), budget);
  } catch (const InputError& first) {
    // It may be what is printed that it does not read.
    const bool printing = std::any_of(files.files.begin(), files.files.end(), [](const auto& file) {
      const std::string text = read_file(file.string());
      return without_prints(text) != text;
    });
    if (!printing) throw;
    fs::create_directory(again);
    try {
      said = yosys(reading(files, again, own, false), budget);
    } catch (const InputError&) {
      throw InputError(first.what());
    }
  }
  ports(read_file((scratch_->path() / "top.json").string()));
  if (said.find("found logic loop") != std::string::npos) {
    throw InputError(what_ + ": a combinational loop");
  }
}

// What yosys says; it works in the files' folder, and writes nothing there.
std::string Side::yosys(const std::string& script, const Budget& budget) const {
  const std::string own = scratch_->path().string();
  write_file(own + "/script.ys", script);
  const Ended ended =
      run_until({"env", "-u", "XDG_STATE_HOME", "-C", files_.folder.string(), "HOME=" + own,
                 "TMPDIR=" + own, "yosys", "-q", "-s", own + "/script.ys"},
                budget.ends());
  if (ended.status == 127) throw InputError("needs yosys");
  if (ended.timed_out) throw OutOfTime();
  if (ended.status != 0) {
    throw InputError(fmt::format("{}: yosys cannot read it: {}", what_,
                                 error_of(ended.text, files_, scratch_->path())));
  }
  return ended.text;
}

std::string Side::form() const {
  return form_of(read_file((scratch_->path() / "top.il").string()));
}

void Side::takes_over(const std::string& by, bool falls) {
  if (clocks.try_emplace(by, falls).first->second != falls) {
    throw InputError(fmt::format("{}: both edges of {} are taken", what_, by));
  }
}

void Side::ports(const std::string& json) {
  const Json read = json_of(json);
  const Json& module = top_of(read);
  std::map<Json, std::string> port_of;
  for (const auto& [port, about] : module.at("ports").items()) {
    const std::string way = about.at("direction");
    if (way == "inout") throw InputError(fmt::format("{}: port {} is inout", what_, port));
    const int width = static_cast<int>(about.at("bits").size());
    (way == "input" ? inputs : outputs)[port] = width;
    declared[port] = declaration(about);
    if (way == "input" && width == 1) port_of[about.at("bits").front()] = port;
  }
  const auto clocked = [&](const Json& bit, bool falls) {
    const auto at = port_of.find(bit);
    if (at == port_of.end()) throw InputError(what_ + ": a clock that is no input");
    takes_over(at->second, falls);
  };
  for (const auto& [cell_name, cell] : module.at("cells").items()) {
    const std::string type = cell.at("type");
    if (type.find("latch") != std::string::npos || type == "$sr") {
      throw InputError(fmt::format("{}: a latch, {}", what_, one_line(cell_name)));
    }
    sets_and_resets = sets_and_resets || type.starts_with("$dffsr");
    const Json& pins = cell.at("connections");
    const Json& about = cell.at("parameters");
    if (type == "$mem_v2") {
      const std::string edges = about.at("WR_CLK_POLARITY");
      const std::string enables = about.at("WR_CLK_ENABLE");
      const int writes = whole_number(about.at("WR_PORTS"));
      const auto by = writes > 0 ? port_of.find(pins.at("WR_CLK").front()) : port_of.end();
      for (int i = 0; i < writes; ++i) {
        const std::size_t at = edges.size() - 1 - static_cast<std::size_t>(i);
        if (enables.at(at) != '1') throw InputError(what_ + ": a memory that no clock writes");
        clocked(pins.at("WR_CLK").at(static_cast<std::size_t>(i)), edges.at(at) == '0');
        if (pins.at("WR_CLK").at(static_cast<std::size_t>(i)) != pins.at("WR_CLK").front()) {
          throw InputError(what_ + ": a memory that two clocks write");
        }
      }
      const std::string first = about.at("INIT");
      std::string shape;
      for (const auto& [name, value] : about.items()) {
        const auto text = value.get<std::string>();
        if (is_of_shape(name, text)) shape += name + ' ' + text + ' ';
      }
      memories.push_back({cell_name, shape, first.find('x') != std::string::npos,
                          whole_number(about.at("WIDTH")), whole_number(about.at("ABITS")),
                          whole_number(about.at("RD_PORTS")), writes,
                          by == port_of.end() ? "" : by->second});
    } else if (type.starts_with("$") && pins.contains("CLK")) {
      const std::string polarity = about.at("CLK_POLARITY");
      clocked(pins.at("CLK").front(), polarity.back() == '0');
      if (!pins.contains("ARST")) continue;
      if (const auto at = port_of.find(pins.at("ARST").front()); at != port_of.end()) {
        const std::string active = about.at("ARST_POLARITY");
        asynchronous_resets[at->second] = active.back() == '1';
      }
    }
  }
  for (const auto& [port, falls] : clocks) {
    if (is_read(module, module.at("ports").at(port).at("bits").front()))
      clocks_as_data.insert(port);
  }
}

}  // namespace cosim::equiv
