// Several clocks as one (clock enables): an input that is a clock says whether it takes its edge on
// the step. A flip-flop of that clock holds its value on a step on which it does not, so that on
// every step all flip-flops take what their enables give them. What resets or loads it at once does
// so on any step.
//
// async2sync, which comes after, does not know such flip-flops: the reset is written out here as it
// would.
#include "tb/proof/steps.h"

#include "tb/support/output_file.h"

namespace cosim::proof {
namespace {

// Behind a flip-flop of another kind stands its initial value, which yosys has at the net.
constexpr const char* flip_flops = R"((* techmap_celltype = "$dff" *)
module cosim_dff #(parameter WIDTH = 1, CLK_POLARITY = 1)
    (input CLK, input [WIDTH-1:0] D, output [WIDTH-1:0] Q);
  \$ff #(.WIDTH(WIDTH)) _TECHMAP_REPLACE_ (.D(CLK ? D : Q), .Q(Q));
endmodule

(* techmap_celltype = "$adff" *)
module cosim_adff #(parameter WIDTH = 1, CLK_POLARITY = 1, ARST_POLARITY = 1, ARST_VALUE = 0)
    (input CLK, ARST, input [WIDTH-1:0] D, output [WIDTH-1:0] Q);
  parameter _TECHMAP_WIREINIT_Q_ = {WIDTH{1'bx}};
  wire [WIDTH-1:0] _TECHMAP_REMOVEINIT_Q_ = {WIDTH{1'b1}};
  (* init = _TECHMAP_WIREINIT_Q_ *)
  wire [WIDTH-1:0] held;
  wire [WIDTH-1:0] next = CLK ? D : Q, after;
  generate
    if (ARST_POLARITY) begin
      assign Q = ARST ? ARST_VALUE : held;
      assign after = ARST ? ARST_VALUE : next;
    end else begin
      assign Q = ARST ? held : ARST_VALUE;
      assign after = ARST ? next : ARST_VALUE;
    end
  endgenerate
  \$ff #(.WIDTH(WIDTH)) _TECHMAP_REPLACE_ (.D(after), .Q(held));
endmodule

(* techmap_celltype = "$aldff" *)
module cosim_aldff #(parameter WIDTH = 1, CLK_POLARITY = 1, ALOAD_POLARITY = 1)
    (input CLK, ALOAD, input [WIDTH-1:0] AD, D, output [WIDTH-1:0] Q);
  parameter _TECHMAP_WIREINIT_Q_ = {WIDTH{1'bx}};
  wire [WIDTH-1:0] _TECHMAP_REMOVEINIT_Q_ = {WIDTH{1'b1}};
  (* init = _TECHMAP_WIREINIT_Q_ *)
  wire [WIDTH-1:0] held;
  wire on = ALOAD ^ !ALOAD_POLARITY;
  assign Q = on ? AD : held;
  \$ff #(.WIDTH(WIDTH)) _TECHMAP_REPLACE_ (.D(on ? AD : CLK ? D : Q), .Q(held));
endmodule
)";

}  // namespace

std::string step_commands(const Source& source, const std::filesystem::path& folder) {
  if (!source.clocks_are_inputs) return "";
  const std::string file = (folder / "steps.v").string();
  OutputFile out(file);
  out.text(flip_flops);
  out.close();
  return "; dffunmap; techmap -map " + file;
}

}  // namespace cosim::proof
