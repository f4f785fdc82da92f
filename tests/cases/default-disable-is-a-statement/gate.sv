module t(input clk, input rst, input [31:0] a, b, input [15:0] d, e, output [15:0] y);
logic [15:0] r; always_comb begin r = 0; begin : bb case (d[1:0]) 1: r = e;  endcase r = r + 1; end end
assign y = r;
endmodule
