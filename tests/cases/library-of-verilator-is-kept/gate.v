module t(input clk, we, d, input [1:0] i, p, input [2:0] j, q, output y);
  reg [14:0] m;
  always @(posedge clk) if (we && i < 3 && j < 5) m[i * 5 + j] <= d;
  assign y = p < 3 && q < 5 ? m[p * 5 + q] : 1'b0;
endmodule
