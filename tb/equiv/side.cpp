#include "tb/equiv/side.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "model/core/input_error.h"
#include "tb/support/json.h"
#include "tb/support/output_file.h"
#include "tb/support/pattern.h"
#include "tb/support/process.h"
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
// types is read as a command. A file stands in its own folder, where $readmemh looks for others.
std::string reading(const Files& files, const fs::path& scratch) {
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
    if (plain.whole(file).empty()) {
      file = fmt::format("file{}.v", i);
      fs::create_symlink(fs::absolute(files.files[i]), scratch / file);
      file = word_for_yosys((scratch / file).string());
    } else {
      file = folders.at(fs::absolute(files.files[i]).parent_path()) + '/' + file;
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
  const std::string own = word_for_yosys(scratch.string());
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
  return one_line(text);
}

// The module that a netlist of one has.
Json& top_of(Json& netlist) {
  for (auto& [name, module] : netlist.at("modules").items()) {
    if (module.at("attributes").contains("top")) return module;
  }
  throw InputError("yosys has written no top");
}

int whole_number(const Json& parameter) {
  return static_cast<int>(std::stoul(parameter.get<std::string>(), nullptr, 2));
}

// Memories as ports of the module.
std::string with_ports_for_memories(Json netlist) {
  Json& module = top_of(netlist);
  std::size_t n = 0;
  Json cells = module.at("cells");
  for (auto& [name, cell] : module.at("cells").items()) {
    if (cell.at("type") != "$mem_v2") continue;
    for (const char* port : {"RD_DATA", "RD_ADDR", "WR_EN", "WR_ADDR", "WR_DATA"}) {
      const bool comes = port == std::string_view("RD_DATA");
      module["ports"][memory_port(n, port)] = {{"direction", comes ? "input" : "output"},
                                               {"bits", cell.at("connections").at(port)}};
    }
    cells.erase(name);
    ++n;
  }
  module["cells"] = std::move(cells);
  return netlist.dump();
}

}  // namespace

std::string memory_port(std::size_t memory, const char* port) {
  return fmt::format("cosim.memory{}.{}", memory, port);
}

void require_name(const std::string& option, const std::string& name) {
  static const Pattern good(R"([A-Za-z_][\w$]*)");
  if (good.whole(name).empty()) {
    throw InputError(fmt::format("{}: {} is no name of Verilog", option, in_quotes(name)));
  }
}

Side::Side(const Files& files, std::string what, const Budget& budget)
    : files_(files), what_(std::move(what)), scratch_(std::make_shared<const Scratch>()) {
  require_name("--top", files.top);
  for (const fs::path& file : files.files) read_file(file.string());
  for (const fs::path& folder : files.include_dirs) {
    if (!fs::is_directory(folder)) {
      throw InputError(fmt::format("--include: {} is no folder", in_quotes(folder.string())));
    }
  }
  const std::string said = yosys(reading(files, scratch_->path()), budget);
  ports(read_file((scratch_->path() / "top.json").string()));
  if (said.find("found logic loop") != std::string::npos) {
    throw InputError(what_ + ": a combinational loop");
  }
}

// What yosys says; it works in the files' folder, and writes nothing there.
std::string Side::yosys(const std::string& script, const Budget& budget) const {
  const std::string own = scratch_->path().string();
  OutputFile file(own + "/script.ys");
  file.text(script);
  file.close();
  const Ended ended =
      run_program({"env", "-u", "XDG_STATE_HOME", "-C", files_.folder.string(), "HOME=" + own,
                   "TMPDIR=" + own, "yosys", "-q", "-s", own + "/script.ys"},
                  budget.left());
  if (ended.status == 127) throw InputError("needs yosys");
  if (ended.timed_out) throw OutOfTime();
  if (ended.status != 0) {
    throw InputError(fmt::format("{}: yosys cannot read it: {}", what_,
                                 error_of(ended.text, files_, scratch_->path())));
  }
  return ended.text;
}

void Side::make_gates(Memories how, const Budget& budget) {
  const fs::path own = scratch_->path();
  const std::string name = word_for_yosys(own.string());
  std::string script = fmt::format("read_rtlil {}/top.il; memory_map\n", name);
  if (how == Memories::cut && !memories.empty()) {
    OutputFile file((own / "cut.json").string());
    file.text(with_ports_for_memories(json_of(read_file((own / "top.json").string()))));
    file.close();
    script = fmt::format("read_json {}/cut.json\n", name);
  }
  script += fmt::format(
      "opt -full; async2sync; dffunmap; opt_clean; simplemap; techmap; dffunmap\n"
      "opt_clean; setundef -anyseq; opt_clean; aigmap; opt_clean\n"
      "write_aiger -ascii -vmap {0}/top.map {0}/top.aag\n"
      "delete c:*; opt_clean -purge; write_json {0}/constants.json\n",
      name);
  yosys(script, budget);
  for (auto* all : {&in_, &state_, &next_, &out_}) all->clear();
  in_names_.clear();
  out_names_.clear();
  constants_.clear();
  registers.clear();
  unknowns = 0;
  read(read_file((own / "top.aag").string()), read_file((own / "top.map").string()));
  read_constants(read_file((own / "constants.json").string()));
}

void Side::takes_over(const std::string& by, bool falls) {
  if (!clock.empty() && (clock != by || falls != falling)) {
    throw InputError(fmt::format("{}: two clocks, {} and {}; one is compared", what_, clock,
                                 by + (falls ? " falling" : "")));
  }
  clock = by;
  falling = falls;
}

void Side::ports(const std::string& json) {
  Json read = json_of(json);
  const Json& module = top_of(read);
  std::map<Json, std::string> port_of;
  for (const auto& [port, about] : module.at("ports").items()) {
    const std::string way = about.at("direction");
    if (way == "inout") throw InputError(fmt::format("{}: port {} is inout", what_, port));
    const int width = static_cast<int>(about.at("bits").size());
    (way == "input" ? inputs : outputs)[port] = width;
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
    const Json& pins = cell.at("connections");
    const Json& about = cell.at("parameters");
    if (type == "$mem_v2") {
      const std::string edges = about.at("WR_CLK_POLARITY");
      const std::string enables = about.at("WR_CLK_ENABLE");
      const int writes = whole_number(about.at("WR_PORTS"));
      for (int i = 0; i < writes; ++i) {
        const std::size_t at = edges.size() - 1 - static_cast<std::size_t>(i);
        if (enables.at(at) != '1') throw InputError(what_ + ": a memory that no clock writes");
        clocked(pins.at("WR_CLK").at(static_cast<std::size_t>(i)), edges.at(at) == '0');
      }
      const std::string first = about.at("INIT");
      std::string shape;
      for (const auto& [name, value] : about.items()) {
        if (name != "MEMID") shape += value.get<std::string>() + ' ';
      }
      memories.push_back({cell_name, shape, first.find('x') != std::string::npos,
                          whole_number(about.at("WIDTH")), whole_number(about.at("ABITS")),
                          whole_number(about.at("RD_PORTS")), writes});
    } else if (type.starts_with("$") && pins.contains("CLK")) {
      const std::string polarity = about.at("CLK_POLARITY");
      clocked(pins.at("CLK").front(), polarity.back() == '0');
    }
  }
}

void Side::read(const std::string& aiger, const std::string& map) {
  std::istringstream in(aiger);
  std::string word;
  std::size_t top = 0, inputs_count = 0, latches = 0, out_count = 0, gates = 0;
  in >> word >> top >> inputs_count >> latches >> out_count >> gates;
  in_.resize(inputs_count);
  out_.resize(out_count);
  gates_.resize(gates);
  for (unsigned& lit : in_) in >> lit;
  std::string line;
  std::getline(in, line);
  std::map<unsigned, std::size_t> register_of;
  for (std::size_t i = 0; i < latches; ++i) {
    std::getline(in, line);
    std::istringstream numbers(line);
    unsigned lit = 0, next = 0, first = 0;
    numbers >> lit >> next >> first;
    register_of[lit] = i;
    state_.push_back(lit);
    next_.push_back(next);
    registers.push_back({{}, first > 1, first == 1});
  }
  for (unsigned& lit : out_) in >> lit;
  std::map<unsigned, Gate> made;
  for (Gate& gate : gates_) {
    in >> gate.out >> gate.a >> gate.b;
    made[gate.out] = gate;
  }
  std::istringstream lines(map);
  std::string kind, name;
  std::size_t lit = 0;
  int bit = 0;
  while (lines >> kind >> lit >> bit && std::getline(lines >> std::ws, name)) {
    if (kind == "input") in_names_[lit] = {name, bit};
    if (kind == "output") out_names_.emplace(lit, Name{name, bit});
    if (kind != "wire" || name.starts_with("$")) continue;
    // A register with an asynchronous reset lies behind the gate that has its name.
    unsigned at = static_cast<unsigned>(lit) & ~1U;
    if (const auto gate = made.find(at); gate != made.end()) {
      const bool a = register_of.contains(gate->second.a & ~1U);
      const bool b = register_of.contains(gate->second.b & ~1U);
      if (a != b) at = (a ? gate->second.a : gate->second.b) & ~1U;
    }
    const auto found = register_of.find(at);
    if (found == register_of.end()) continue;
    Name& own = registers[found->second].name;
    if (own.first.empty() || (at == lit && Name{name, bit} < own)) own = {name, bit};
  }
  for (std::size_t i = 0; i < in_.size(); ++i) unknowns += in_names_.contains(i) ? 0U : 1U;
}

// An output that is a constant has no line in the map.
void Side::read_constants(const std::string& json) {
  const Json top = json_of(json);
  for (const auto& [name, module] : top.at("modules").items()) {
    for (const auto& [port, about] : module.at("ports").items()) {
      if (about.at("direction") != "output") continue;
      int bit = 0;
      for (const Json& driver : about.at("bits")) {
        if (driver.is_string()) constants_[{port, bit}] = driver == "1" ? 1U : 0U;
        ++bit;
      }
    }
  }
}

Side::Made Side::make(proof::Aig& graph, const std::function<Lit(const Name&)>& input,
                      const std::vector<Lit>& unknown, const std::vector<Lit>& state) const {
  std::vector<Lit> value(2 * (in_.size() + state_.size() + gates_.size()) + 2, 0);
  const auto of = [&](unsigned lit) { return value[lit / 2] ^ (lit & 1U); };
  std::size_t next_unknown = 0;
  for (std::size_t i = 0; i < in_.size(); ++i) {
    const auto name = in_names_.find(i);
    value[in_[i] / 2] = name == in_names_.end() ? unknown[next_unknown++] : input(name->second);
  }
  for (std::size_t i = 0; i < state_.size(); ++i) value[state_[i] / 2] = state[i];
  for (const Gate& gate : gates_) value[gate.out / 2] = graph.both(of(gate.a), of(gate.b));
  Made made;
  for (const auto& [name, lit] : constants_) made.outputs[name] = lit;
  for (const auto& [i, name] : out_names_) made.outputs[name] = of(out_[i]);
  for (const unsigned next : next_) made.next.push_back(of(next));
  return made;
}

}  // namespace cosim::equiv
