module t(input bit [3:0] a, input [2:0] i, output bit y); assign y = i > 3 ? 1 : a[i[1:0]]; endmodule
