// The registers drive an output of the same name, and --same names them too.
module t(input clk, d, output y);
  reg s = 0;
  always @(posedge clk) s <= d;
  assign y = s;
endmodule
