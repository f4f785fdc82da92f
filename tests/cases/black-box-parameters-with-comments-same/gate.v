module t(input a, output y);
  (* keep *)  // (* not this *)
  PLL
    #(.PERIOD(10), // ns, of 100 MHz
      .MODE("A,B("), /* the first, the second */
      .MULTIPLY(16)) // 1.6 GHz
    p(.A(a), .Y(y));
endmodule
