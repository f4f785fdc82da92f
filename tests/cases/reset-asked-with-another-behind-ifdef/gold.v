// What stands in `ifdef is not written twice.
module t(input clk, rst_n, clear, input [3:0] d, output reg [3:0] q);
  always @(posedge clk or negedge rst_n)
    if (!rst_n || clear) begin
`ifdef ONES
      q <= 4'hf;
`else
      q <= 4'h0;
`endif
    end else q <= d;
endmodule
