module t(input clk, rst, we, input [1:0] i, input j, input [3:0] d, output [3:0] q);
  reg [3:0] m [0:7];
  integer x;
  always @(posedge clk)
    if (rst) begin
      for (x = 0; x < 8; x = x + 1) m[x] <= 0;
    end else if (we) m[{j, i}] <= d;
  assign q = m[{j, i}];
endmodule
