module t(input clk, input rst, input a, output y);
  reg [3:0] s;
  always @(posedge clk) if (rst) s <= 1;
  else case (1)
    s[0]: if (a) s <= 2;
    s[1]: s <= a ? 4 : 1;
    s[2]: s <= a ? 8 : 1;
    s[3]: if (!a) s <= 1;
  endcase
  assign y = s[3];
endmodule
