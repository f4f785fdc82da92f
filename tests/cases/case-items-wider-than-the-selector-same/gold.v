// Items of more bits are compared with all of them.
module t(input [1:0] s, output reg [1:0] y);
  always @*
    case (s)
      3'b110: y = 1;
      3'b010: y = 2;
      default: y = 3;
    endcase
endmodule
