// The port \a[0] is another one than bit 0 of a.
module t(input [1:0] a, input \a[0] , output y);
  assign y = a[0];
endmodule
