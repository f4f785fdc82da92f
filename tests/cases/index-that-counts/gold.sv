module t(input clk, input rst, input [7:0] a, input [7:0] b, input [2:0] s, input [3:0] c, input e, input [31:0] d, output [15:0] y);
logic [3:0] m[4]; int i; always_comb begin m='{1,2,3,4}; i=0; m[i++] += a[3:0]; end assign y={m[0],m[1],m[2],i[3:0]}; endmodule
