`ifdef LIMIT
`define N 5
`else
`define N 3
`endif
module t(input [3:0] a, output y);
  assign y = a > `N;
endmodule
