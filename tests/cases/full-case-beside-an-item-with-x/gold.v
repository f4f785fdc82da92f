// An item with an x stands beside a case that covers all values and has no default: no latch.
module t(input [3:0] a, input s, output reg y, z);
  always @*
    case (a)
      4'b0x00: y = a[0];
      4'b0000: y = 1;
      default: y = 0;
    endcase
  always @*
    case (s)
      1'b0: z = a[0];
      1'b1: z = a[1];
    endcase
endmodule
