module t(input [15:0] d, e, output reg [15:0] y);
 always @(d) y = d & e;
endmodule
