module t(input clk, rst_n, input [3:0] d, output reg [3:0] q);
  always @(posedge clk or negedge rst_n)
    if (!rst_n) q <= 4'ha;
    else q <= {d[0], d[1], d[2], d[3]};
endmodule
