module t(input e, input signed [3:0] p, output y); assign y = e; endmodule
