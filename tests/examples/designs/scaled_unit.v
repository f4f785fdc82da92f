`include "scaled.vh"
module scaled_unit #(parameter W = 4) (
    input  wire [W-1:0] d,
    output wire [W-1:0] q
);
  assign q = `SCALED_STEP_OF(d);
endmodule
