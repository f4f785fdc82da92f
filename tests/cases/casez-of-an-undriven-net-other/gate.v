module t(input a, output reg y); wire u = 0; always @* casez ({a,u}) 2'b11: y=1; 2'b0?: y=0; default: y=0; endcase endmodule
