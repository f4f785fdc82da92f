module t(input clk, rst, input [31:0] d, output reg q);
  reg seen;
  always @(posedge clk)
    if (rst) begin
      seen = 0;
      q <= 0;
    end else begin
      seen = d[0];
      q <= d == 32'hdeadbeef && d[1] || seen;
    end
endmodule
