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
#include "tb/support/read_file.h"
#include "tb/support/words.h"

namespace cosim::equiv {
namespace {

namespace fs = std::filesystem;
using Lit = proof::Aig::Lit;

// What goes to yosys is in a script, and the files have names of ours there: nothing that a person
// types is read as a command.
std::string script(const Files& files, const fs::path& scratch) {
  std::string options = " -defer -D SYNTHESIS";
  int n = 0;
  const auto link_folder = [&](const fs::path& folder) {
    const std::string name = fmt::format("include{}", n++);
    fs::create_directory_symlink(fs::absolute(folder), scratch / name);
    options += " -I" + name;
  };
  std::set<fs::path> folders;
  for (const fs::path& file : files.files) folders.insert(fs::absolute(file).parent_path());
  for (const fs::path& folder : folders) link_folder(folder);
  for (const fs::path& folder : files.include_dirs) link_folder(folder);
  for (const std::string& define : files.defines) {
    static const Pattern good(R"([A-Za-z_]\w*(=[\w']+)?)");
    if (good.whole(define).empty()) {
      throw InputError(fmt::format("--define: {} is not NAME or NAME=VALUE", in_quotes(define)));
    }
    options += " -D" + define;
  }
  std::string text;
  for (std::size_t i = 0; i < files.files.size(); ++i) {
    fs::create_symlink(fs::absolute(files.files[i]), scratch / fmt::format("file{}.v", i));
    const bool is_system_verilog = files.files[i].extension() == ".sv";
    text += fmt::format("read_verilog{}{} file{}.v\n", is_system_verilog ? " -sv" : "", options, i);
  }
  text += "hierarchy -check -top " + files.top;
  for (const std::string& parameter : files.parameters) {
    static const Pattern good(R"(([A-Za-z_][\w$]*)=([\w']+|"\w*"))");
    const Pattern::Parts part = good.whole(parameter);
    if (part.empty()) {
      throw InputError(fmt::format("--param: {} is not NAME=VALUE", in_quotes(parameter)));
    }
    text += fmt::format(" -chparam {} {}", part[1], part[2]);
  }
  return text +
         "\nproc; check; setundef -undriven -anyseq; flatten; opt_clean; write_json top.json\n"
         "memory_map; opt -full; async2sync; dffunmap; opt_clean; simplemap; techmap; dffunmap\n"
         "opt_clean; setundef -anyseq; opt_clean; aigmap; opt_clean\n"
         "write_aiger -ascii -vmap top.map top.aag\n"
         "delete c:*; opt_clean -purge; write_json constants.json\n";
}

// The line of the error, with the files by their own names.
std::string error_of(std::string text, const Files& files) {
  const std::size_t at = std::min(text.find("ERROR"), text.size());
  const std::size_t newline = text.rfind('\n', at);
  text = text.substr(newline == std::string::npos ? 0 : newline + 1);
  text.resize(std::min(text.find('\n'), text.size()));
  for (std::size_t i = files.files.size(); i-- > 0;) {
    const std::string own = fmt::format("file{}.v", i);
    for (std::size_t p = 0; (p = text.find(own, p)) != std::string::npos;) {
      text.replace(p, own.size(), files.files[i].string());
      p += files.files[i].string().size();
    }
  }
  return one_line(text);
}

}  // namespace

void require_name(const std::string& option, const std::string& name) {
  static const Pattern good(R"([A-Za-z_][\w$]*)");
  if (good.whole(name).empty()) {
    throw InputError(fmt::format("{}: {} is no name of Verilog", option, in_quotes(name)));
  }
}

Side::Side(const Files& files, const std::string& what, int seconds) {
  require_name("--top", files.top);
  for (const fs::path& file : files.files) read_file(file.string());
  for (const fs::path& folder : files.include_dirs) {
    if (!fs::is_directory(folder)) {
      throw InputError(fmt::format("--include: {} is no folder", in_quotes(folder.string())));
    }
  }
  const Scratch scratch;
  const std::string own = scratch.path().string();
  OutputFile file(own + "/read.ys");
  file.text(script(files, scratch.path()));
  file.close();
  const Ended ended = run_program({"env", "-u", "XDG_STATE_HOME", "-C", own, "HOME=" + own,
                                   "TMPDIR=" + own, "yosys", "-q", "-s", "read.ys"},
                                  seconds);
  if (ended.status == 127) throw InputError("needs yosys");
  if (ended.timed_out) {
    throw InputError(fmt::format("{}: yosys does not read it in {} s (--seconds)", what, seconds));
  }
  if (fs::exists(own + "/top.json")) ports(read_file(own + "/top.json"), what);
  if (ended.text.find("found logic loop") != std::string::npos) {
    throw InputError(what + ": a combinational loop");
  }
  if (ended.status != 0) {
    throw InputError(
        fmt::format("{}: yosys cannot read it: {}", what, error_of(ended.text, files)));
  }
  read(read_file(own + "/top.aag"), read_file(own + "/top.map"));
  read_constants(read_file(own + "/constants.json"));
}

void Side::ports(const std::string& json, const std::string& what) {
  const Json read = json_of(json);
  for (const auto& [name, module] : read.at("modules").items()) {
    if (!module.at("attributes").contains("top")) continue;
    std::map<Json, std::string> port_of;
    for (const auto& [port, about] : module.at("ports").items()) {
      const std::string way = about.at("direction");
      if (way == "inout") throw InputError(fmt::format("{}: port {} is inout", what, port));
      const int width = static_cast<int>(about.at("bits").size());
      (way == "input" ? inputs : outputs)[port] = width;
      if (way == "input" && width == 1) port_of[about.at("bits")] = port;
    }
    for (const auto& [cell_name, cell] : module.at("cells").items()) {
      const std::string type = cell.at("type");
      if (type.find("latch") != std::string::npos || type == "$sr") {
        throw InputError(fmt::format("{}: a latch, {}", what, one_line(cell_name)));
      }
      const Json& pins = cell.at("connections");
      if (!type.starts_with("$") || !pins.contains("CLK") || type.starts_with("$mem")) continue;
      const auto at = port_of.find(pins.at("CLK"));
      if (at == port_of.end()) throw InputError(what + ": a clock that is no input");
      const std::string polarity = cell.at("parameters").at("CLK_POLARITY");
      const bool falls = polarity.back() == '0';
      if (!clock.empty() && (clock != at->second || falls != falling)) {
        throw InputError(fmt::format("{}: two clocks, {} and {}; one is compared", what, clock,
                                     at->second + (falls ? " falling" : "")));
      }
      clock = at->second;
      falling = falls;
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
    if (kind == "output") out_names_[lit] = {name, bit};
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
