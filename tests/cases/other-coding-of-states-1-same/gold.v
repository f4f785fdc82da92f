// The states have other codes.
module t(input clk, input rst, input a, output y);
  reg [1:0] s;
  always @(posedge clk) if (rst) s <= 0;
  else case (s)
    0: if (a) s <= 1;
    1: s <= a ? 2 : 0;
    2: s <= a ? 3 : 0;
    3: if (!a) s <= 0;
  endcase
  assign y = s == 3;
endmodule
