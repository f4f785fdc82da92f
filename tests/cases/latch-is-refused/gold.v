// y keeps its value where en is 0.
module t(input en, d, output reg y);
  always @* if (en) y = d;
endmodule
