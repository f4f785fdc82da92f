// One of two RTLs that are compared, as gates and registers.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tb/proof/aig.h"

namespace cosim::equiv {

/// Verilog as a person names it.
struct Files {
  std::vector<std::filesystem::path> files;
  std::string top;
  std::vector<std::string> parameters;  ///< "NAME=VALUE", as Verilog writes the value
  std::vector<std::filesystem::path> include_dirs;
  std::vector<std::string> defines;  ///< "NAME" or "NAME=VALUE"
};

/// A bit of a port, a net or a register: its hierarchical name, and which bit.
using Name = std::pair<std::string, int>;

struct Register {
  Name name;           ///< empty where the RTL has none
  bool any = false;    ///< it has no initial value
  bool first = false;  ///< what it is, if it has one
};

class Side {
 public:
  /// Reads the files with yosys in at most `seconds`. A register that takes over at once what an
  /// asynchronous reset gives is one of the clock and a multiplexer. InputError, one line that
  /// begins with `what` or a file, where yosys cannot, and for a second clock, a clock that is no
  /// input, a latch, a bidirectional port or a combinational loop.
  Side(const Files& files, const std::string& what, int seconds);

  std::map<std::string, int> inputs, outputs;  ///< ports and their widths
  std::string clock;                           ///< empty where there are no registers
  bool falling = false;                        ///< registers take over when it falls
  std::vector<Register> registers;
  std::size_t unknowns = 0;  ///< bits that the RTL leaves x

  struct Made {
    std::map<Name, proof::Aig::Lit> outputs;
    std::vector<proof::Aig::Lit> next;  ///< of the registers
  };
  /// Its gates in `graph`; what the inputs, the unknown bits and the registers are is given.
  Made make(proof::Aig& graph, const std::function<proof::Aig::Lit(const Name&)>& input,
            const std::vector<proof::Aig::Lit>& unknown,
            const std::vector<proof::Aig::Lit>& state) const;

 private:
  struct Gate {
    unsigned out, a, b;
  };
  void read(const std::string& aiger, const std::string& map);
  void read_constants(const std::string& json);
  void ports(const std::string& json, const std::string& what);

  std::vector<unsigned> in_, state_, next_, out_;
  std::vector<Gate> gates_;
  std::map<std::size_t, Name> in_names_, out_names_;
  std::map<Name, proof::Aig::Lit> constants_;  ///< outputs that are 0 or 1
};

/// InputError "OPTION: ..." where `name` is no name of Verilog.
void require_name(const std::string& option, const std::string& name);

}  // namespace cosim::equiv
