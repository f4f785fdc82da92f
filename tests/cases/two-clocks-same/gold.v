// Each of two clocks may have its edge alone.
module t(input a, b, rst, input [1:0] d, output reg [1:0] q);
  reg [1:0] p;
  always @(posedge a)
    if (rst) p <= 0;
    else p <= d;
  always @(posedge b)
    if (rst) q <= 0;
    else q <= p + 1;
endmodule
