module t(input clk, we, d, input [1:0] i, p, input [2:0] j, q, output y);
  reg m [0:2][0:4];
  always @(posedge clk) if (we) m[i][j] <= d;
  assign y = p < 3 && q < 5 ? m[p][q] : 1'b0;
endmodule
