module t(input en, d, output reg y);
  always @* if (en) y = d;
endmodule
