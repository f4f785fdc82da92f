module t(input clk, input d, output reg q, output r); assign r = !(!d); always @(posedge clk) q <= d; endmodule
