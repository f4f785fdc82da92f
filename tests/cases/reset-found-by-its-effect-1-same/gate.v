module t(input clk, input resetq, input a, output y);
  reg [1:0] s;
  always @(posedge clk) if (!resetq) s <= 0;
  else if (a) s <= s == 2 ? 0 : s + 1;
  assign y = s == 2;
endmodule
