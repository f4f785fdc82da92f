// An assumption with an output in it.
module t(input clk, input rst, input up, output full, output reg [1:0] n);
  assign full = n == 3;
  always @(posedge clk) if (rst) n <= 0;
  else if (up & !full) n <= n + 1;
endmodule
