module t(input clk, rst, a, en, output y);
  reg [19:0] n;
  always @(posedge clk) n <= rst ? 0 : n + 1;
  assign y = a ^ (en && n == 20'hf0000);
endmodule
