#include "tb/proof/yosys.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "model/core/input_error.h"
#include "tb/util/output_file.h"
#include "tb/util/place.h"
#include "tb/util/process.h"
#include "tb/util/quoted.h"

namespace cosim::proof {
namespace {

namespace fs = std::filesystem;

std::string as_constant(const Source& source, const Parameter& p) {
  const auto found = source.constants.find(p.name);
  return found == source.constants.end() ? to_text(p) : found->second;
}

}  // namespace

std::string kept_net(const std::string& name) {
  std::string pattern = name;  // what a pattern or a command takes otherwise stands for any
  for (char& c : pattern) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (!plain && std::string_view("_$.").find(c) == std::string_view::npos) c = '?';
  }
  return fmt::format(" w:{0} w:{0}\\[* w:*.{0} w:*.{0}\\[*", pattern);
}

std::string read_commands(const Source& source) {
  if (!source.written.empty()) {
    return fmt::format("read_verilog -sv {}; ", file_for_yosys(source.written));
  }
  std::string options;
  for (const fs::path& folder : source.include_dirs)
    options += " " + word_for_yosys("-I" + folder.string());
  for (const std::string& define : source.defines) options += " " + word_for_yosys("-D" + define);
  std::string commands;
  for (const fs::path& file : source.files) {
    const bool is_system_verilog = file.extension() == ".sv" || file.extension() == ".svh";
    commands += fmt::format("read_verilog -defer{}{} {}; ", is_system_verilog ? " -sv" : "",
                            options, file_for_yosys(file));
  }
  return commands;
}

std::string commands_to_elaborate(const Source& source) {
  std::string commands =
      read_commands(source) + "hierarchy -check -top " + word_for_yosys(source.top);
  if (!source.written.empty()) return commands;
  for (const Parameter& p : source.parameters) {
    commands += fmt::format(" -chparam {} {}", p.name, word_for_yosys(as_constant(source, p)));
  }
  return commands;
}

// As prep -flatten -nomem does it, but without removing a flip-flop whose next value is a constant
// or that of another one: it is a register as any other.
std::string flat_commands(const Source& source) {
  constexpr const char* no_flip_flop = "t:* t:$*ff* %d";
  std::string kept = "w:*_q";
  for (const std::string& net : source.kept) kept += kept_net(net.substr(net.rfind('.') + 1));
  return commands_to_elaborate(source) +
         fmt::format(
             "; rename -top {0}; setattr -set keep 1 {1}; proc; flatten; opt_expr -keepdc; "
             "opt_clean; {2}; wreduce -keepdc {3}; {2}; {2}; memory_collect; memory_map; "
             "setattr -set keep 1 {1}",
             source.top, kept,
             fmt::format("opt_merge {0}; opt_muxtree; opt_reduce; opt_merge {0}; opt_clean; "
                         "opt_expr -keepdc",
                         no_flip_flop),
             no_flip_flop);
}

void run_yosys(const std::string& commands, const std::string& what) {
  // yosys keeps a history in the user's home, and leaves its files where it is stopped.
  const Scratch scratch;
  const std::string own = scratch.path().string();
  // A name in an interface that yosys does not know is a new net for it, with a warning.
  const Ended ended =
      run_program({"env", "-u", "XDG_STATE_HOME", "HOME=" + own, "TMPDIR=" + own, "yosys", "-q",
                   "-e", "Identifier .*[.$].* is implicitly declared", "-p", commands});
  if (ended.status == 127) throw InputError("needs yosys");
  if (ended.status == 0) return;
  // The line of the error: it begins with the file and the line of the RTL.
  const std::size_t at = std::min(ended.text.find("ERROR"), ended.text.size());
  const std::size_t newline = ended.text.rfind('\n', at);
  std::string error = ended.text.substr(newline == std::string::npos ? 0 : newline + 1);
  error.resize(std::min(error.find('\n'), error.size()));
  throw InputError(fmt::format("{}: yosys cannot read it: {}", what, error));
}

Source read_for(const nets::Machine& machine, Source source) {
  source.asynchronous_reset = !machine.seen.empty();
  source.clocks_are_inputs = machine.clocks_are_inputs;
  for (const auto& w : machine.registers) {
    if (w.field.index <= 0) source.kept.push_back(net_path(w.field.net).path);
  }
  return source;
}

Source source_in(const fs::path& folder, const std::string& design,
                 const std::vector<Parameter>& parameters) {
  Source source{{}, design, parameters};
  std::error_code error;
  const fs::path own = fs::exists(folder / design, error) ? folder / design : folder;
  for (const auto& entry : fs::directory_iterator(own, error)) {
    if (entry.path().extension() == ".v") source.files.push_back(fs::absolute(entry.path()));
  }
  if (source.files.empty()) {
    throw InputError(fmt::format("{}: no Verilog of {}; --rtl DIR names the folder that has it",
                                 folder.string(), design));
  }
  std::sort(source.files.begin(), source.files.end());
  return source;
}

}  // namespace cosim::proof
