module t(input clk, rst, input [3:0] d, output [3:0] y);
  reg [3:0] a0, a1, a2, a3;
  reg [2:0] n;
  always @(posedge clk or posedge rst)
    if (rst) begin
      {a0, a1, a2, a3, n} <= 0;
    end else begin
      n <= n + 1;
      case (n)
        0: a0 <= d;
        1: a1 <= d;
        2: a2 <= d;
        3: a3 <= d;
      endcase
    end
  assign y = a0 ^ a1 ^ a2 ^ a3;
endmodule
