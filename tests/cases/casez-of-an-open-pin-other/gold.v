// A bit that is z matches every item of casez: y is a in the old RTL, and 0 in the new.
module s(input u, input a, output reg y); always @* casez ({a,u}) 2'b11: y=1; default: y=0; endcase endmodule
module t(input a, output y); s k(.a(a), .y(y), .u()); endmodule
