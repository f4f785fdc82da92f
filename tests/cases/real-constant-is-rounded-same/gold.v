// 2.5 as an integer is 3.
module t(input [3:0] a, output [3:0] y);
  localparam real HALF = 2.5;
  localparam integer N = HALF;
  assign y = a + N;
endmodule
