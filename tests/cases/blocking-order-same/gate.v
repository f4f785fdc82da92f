module t(input clk, rst, input [1:0] d, output reg [1:0] p, q);
  always @(posedge clk)
    if (rst) {p, q} <= 0;
    else begin
      p <= d;
      q <= d;
    end
endmodule
