module t(input clk, input [1:0] s, input [15:0] d, e, output logic [15:0] y);
always_ff @(posedge clk) case (s)
 0: y <= e;
 1: ;
 default: y <= d;
endcase
endmodule
