// The resets are named.
module t(input clk, input go, input stop, input a, output y);
  reg [2:0] s;
  always @(posedge clk) if (go && !stop) s <= 1;
  else if (a) s <= {s[1:0], s[2]};
  assign y = s[2];
endmodule
