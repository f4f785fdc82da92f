module s(input u, input a, output reg y); always @* casez ({a,u}) 2'b11: y=1; default: y=0; endcase endmodule
module t(input a, output y); s k(.a(a), .y(y), .u(1'b0)); endmodule
