// Sums and comparisons by a carry that goes from bit to bit (ripple carry), as a model's graph has
// them (nets/number.cpp): sums of both sides are then alike gate by gate. Those of yosys's own look
// ahead (Brent-Kung), and are more gates, which take longer to make.
#include "tb/proof/gates.h"

#include "tb/support/output_file.h"

namespace cosim::proof {
namespace {

constexpr const char* gates_of_cells = R"((* techmap_celltype = "$add $sub" *)
module cosim_sum #(parameter A_SIGNED = 0, B_SIGNED = 0, A_WIDTH = 1, B_WIDTH = 1, Y_WIDTH = 1)
    (input [A_WIDTH-1:0] A, input [B_WIDTH-1:0] B, output [Y_WIDTH-1:0] Y);
  parameter _TECHMAP_CELLTYPE_ = "";
  localparam minus = _TECHMAP_CELLTYPE_ == "$sub";
  wire [Y_WIDTH-1:0] a, b;
  \$pos #(.A_SIGNED(A_SIGNED && B_SIGNED), .A_WIDTH(A_WIDTH), .Y_WIDTH(Y_WIDTH)) of_a (.A(A), .Y(a));
  \$pos #(.A_SIGNED(A_SIGNED && B_SIGNED), .A_WIDTH(B_WIDTH), .Y_WIDTH(Y_WIDTH)) of_b (.A(B), .Y(b));
  wire [Y_WIDTH:0] carry;
  assign carry[0] = minus;
  genvar i;
  generate
    for (i = 0; i < Y_WIDTH; i = i + 1) begin
      wire odd = a[i] ^ b[i] ^ minus;
      assign Y[i] = odd ^ carry[i];
      assign carry[i + 1] = odd ? carry[i] : a[i];
    end
  endgenerate
endmodule

(* techmap_celltype = "$lt $le $gt $ge" *)
module cosim_order #(parameter A_SIGNED = 0, B_SIGNED = 0, A_WIDTH = 1, B_WIDTH = 1, Y_WIDTH = 1)
    (input [A_WIDTH-1:0] A, input [B_WIDTH-1:0] B, output [Y_WIDTH-1:0] Y);
  parameter _TECHMAP_CELLTYPE_ = "";
  localparam turned = _TECHMAP_CELLTYPE_ == "$le" || _TECHMAP_CELLTYPE_ == "$gt";
  localparam negated = _TECHMAP_CELLTYPE_ == "$le" || _TECHMAP_CELLTYPE_ == "$ge";
  localparam is_signed = A_SIGNED && B_SIGNED;
  localparam width = A_WIDTH > B_WIDTH ? A_WIDTH : B_WIDTH;
  wire [width-1:0] a, b;
  \$pos #(.A_SIGNED(is_signed), .A_WIDTH(A_WIDTH), .Y_WIDTH(width)) of_a (.A(A), .Y(a));
  \$pos #(.A_SIGNED(is_signed), .A_WIDTH(B_WIDTH), .Y_WIDTH(width)) of_b (.A(B), .Y(b));
  wire [width-1:0] low = turned ? b : a, high = turned ? a : b;
  wire [width:0] less;
  assign less[0] = 0;
  genvar i;
  generate
    for (i = 0; i < width; i = i + 1) begin
      assign less[i + 1] =
          low[i] ^ high[i] ? (is_signed && i == width - 1 ? low[i] : high[i]) : less[i];
    end
  endgenerate
  assign Y = less[width] ^ negated;
endmodule
)";

}  // namespace

std::string gate_commands(const std::filesystem::path& folder) {
  const std::string file = (folder / "gates.v").string();
  OutputFile out(file);
  out.text(gates_of_cells);
  out.close();
  return "; techmap -map " + file + "; simplemap; techmap";
}

}  // namespace cosim::proof
