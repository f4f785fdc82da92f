// A register that no testbench can name begins as x; y does not depend on it, and keeps its value
// where d is 3.
module t(input clk, input [1:0] d, output reg y, output z);
  reg \a+b ;
  always @(posedge clk) \a+b <= d[0];
  assign z = \a+b ;
  always @*
    (* full_case *) case (d)
      0: y = 0;
      1: y = 1;
      2: y = 1;
    endcase
endmodule
