module t(input a, output y);
  u #(.D(0.5)) i(.a(a), .y(y));
endmodule
module u #(parameter D = 1)(input a, output y);
  PLL #(.PERIOD(D)) p(.A(a), .Y(y));
endmodule
