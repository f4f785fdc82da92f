// Nothing is x.
module t(input bit [3:0] a, input int b, output bit y); assign y = a[b[1:0]]; endmodule
