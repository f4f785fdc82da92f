module t(input clk, a, input [31:0] d, output y);
  reg q = 0, r = 0;
  assign #1 y = r;
  always @(posedge clk) begin
    q <= #1 a;
    if (d == 32'h600dcafe) #2;
    r <= #1 q;
  end
endmodule
