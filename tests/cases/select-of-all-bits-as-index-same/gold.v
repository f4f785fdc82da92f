// All bits of a signed variable, in a process, as the count of a shift and as an index.
module t(input clk, input rst, input signed [2:0] i, input [7:0] d, output reg [7:0] q, p);
  always @(posedge clk)
    if (rst) begin
      q <= 0;
      p <= 0;
    end
    else begin
      q <= d << i[2:0];
      p[i[2:0] +: 2] <= d;
    end
endmodule
