module t(input clk, input go, input stop, input a, output y);
  reg [1:0] s;
  always @(posedge clk) if (go && !stop) s <= 0;
  else if (a) s <= s == 2 ? 0 : s + 1;
  assign y = s == 2;
endmodule
