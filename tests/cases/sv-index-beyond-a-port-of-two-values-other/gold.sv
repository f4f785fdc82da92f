// A bit beyond the end is 0, as no bit is x.
module t(input bit [3:0] a, input [2:0] i, output bit y); assign y = a[i]; endmodule
