module t(input [2:0] at, input signed [1:0] n, output reg [11:0] y);
  wire [11:0] nibble = {8'd0, n[1], n[1], n};
  always @* y = nibble << at;
endmodule
