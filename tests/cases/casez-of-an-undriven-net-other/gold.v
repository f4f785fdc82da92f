// A bit that is z matches every item of casez: y is a in the old RTL, and 0 in the new.
module t(input a, output reg y); wire u; always @* casez ({a,u}) 2'b11: y=1; 2'b0?: y=0; default: y=0; endcase endmodule
