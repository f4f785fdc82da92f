// Adds up its input, scaled: several files, an include folder, a define.
`include "scaled.vh"
module scaled #(parameter FAULT = 0, parameter W = 4) (
    input  wire         clk,
    input  wire         rst,
    input  wire [W-1:0] d,
    output wire [W-1:0] sum
);
  wire [W-1:0] scaled;
  reg  [W-1:0] total;
  assign sum = total;
  scaled_unit #(.W(W)) unit (.d(d), .q(scaled));
  always @(posedge clk)
    if (rst) total <= {W{1'b0}};
    else total <= total + scaled + (FAULT != 0 && &total[2:0]);
endmodule
