module t(input clk, rst_n, input [3:0] d, output [4:0] y);
  reg [3:0] v;
  reg p;
  always @(posedge clk or negedge rst_n)
    if (!rst_n) {v, p} <= 5'b00110;
    else {v, p} <= {d + v, ^d};
  assign y = {v, p};
endmodule
