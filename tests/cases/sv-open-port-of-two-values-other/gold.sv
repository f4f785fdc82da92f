// The open pin is 0, as no bit is x.
module s(input bit k, a, output y); assign y = a ^ k; endmodule
module t(input a, output y); s u(.a(a), .k(), .y(y)); endmodule
