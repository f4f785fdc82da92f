module t(input clk, rst_n, clear, input [3:0] d, output reg [3:0] q);
  always @(posedge clk or negedge rst_n)
    if (!rst_n) q <= 0;
    else q <= clear ? 0 : d;
endmodule
