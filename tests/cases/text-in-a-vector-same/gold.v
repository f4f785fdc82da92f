// A text is at the right end of a vector, with zeros before it.
module t(input [1:0] i, output reg [7:0] y);
  reg [31:0] text = "abc";
  always @*
    case (i)
      0: y = text[7:0];
      1: y = text[15:8];
      2: y = text[23:16];
      3: y = text[31:24];
    endcase
endmodule
