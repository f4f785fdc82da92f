module cosim_replay(input a, output y); assign y = ~a; endmodule
module t(input a, output y); assign y = ~a; endmodule
