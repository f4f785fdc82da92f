// In a plain case an item with x matches no known value.
module t(input [1:0] sel, input [3:0] a, b, output reg [3:0] y);
  always @*
    case (sel)
      2'b1x: y = a;
      2'b10: y = b;
      default: y = a;
    endcase
endmodule
