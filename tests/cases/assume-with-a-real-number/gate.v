module t(input e, input signed [3:0] p, output y); assign y = 1'b0; endmodule
