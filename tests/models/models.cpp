// random_models FOLDER FIRST COUNT CHANGE
//
// Draws a model of each of COUNT seeds from FIRST on. Writes models.h, their structs; and of each
// its module: SEED.v, in which the change of that number is planted unless it is -1, and SEED.tb.v,
// a testbench that prints the outputs of each clock for a line of the file SEED.in: rst and the
// inputs.
#include <cstdlib>
#include <fstream>

#include "tests/models/tree.h"

namespace cosim::models {
namespace {

std::string testbench(const Model& m, const std::string& seed) {
  int width = 1;
  std::string wires, pins = ".clk(clk), .rst(rst)", inputs = "rst", outputs, formats;
  for (const Variable& v : m.inputs) {
    wires += "reg " + verilog(v.type) + v.verilog + ";\n";
    pins += ", ." + v.verilog + '(' + v.verilog + ')';
    inputs += ", " + v.verilog;
    width += v.type.width;
  }
  for (const Variable& v : m.outputs) {
    wires += "wire " + verilog(v.type) + v.verilog + ";\n";
    pins += ", ." + v.verilog + '(' + v.verilog + ')';
    outputs += ", " + v.verilog;
    formats += formats.empty() ? "%b" : " %b";
  }
  return "module tb;\nreg clk = 0, rst;\n" + wires + "t dut(" + pins + ");\nreg " +
         verilog({width, false}) + "all;\ninteger file;\ninitial begin\nfile = $fopen(\"" + seed +
         ".in\", \"r\");\nwhile ($fscanf(file, \"%b\", all) == 1) begin\n{" + inputs +
         "} = all;\n#1 $display(\"" + formats + '"' + outputs +
         ");\n#1 clk = 1;\n#1 clk = 0;\nend\n$finish(0);\nend\nendmodule\n";
}

}  // namespace
}  // namespace cosim::models

int main(int, char** words) {
  using namespace cosim::models;
  const std::string folder = std::string(words[1]) + '/';
  const int first = std::atoi(words[2]), count = std::atoi(words[3]), change = std::atoi(words[4]);
  std::ofstream structs(folder + "models.h");
  std::string visits;
  for (int seed = first; seed < first + count; ++seed) {
    const std::string number = std::to_string(seed);
    const Model model = drawn(static_cast<unsigned>(seed));
    structs << struct_of(model, "M" + number);
    visits += "visit.template operator()<M" + number + ">(\"" + number + "\");\n";
    int sites = 0;
    std::string module = module_of(model, -1, sites);
    if (change >= 0) module = module_of(model, change * 7919 % sites, sites);
    std::ofstream(folder + number + ".v") << module;
    std::ofstream(folder + number + ".tb.v") << testbench(model, number);
  }
  structs << "template <class Visit>\nvoid for_each_model(const Visit& visit) {\n"
          << visits << "}\n";
}
