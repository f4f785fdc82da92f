// A packed array of two dimensions is one vector.
module t(input [11:0] a, input [1:0] i, output [3:0] y);
  logic [2:0][3:0] p;
  assign p = a;
  assign y = i == 3 ? 4'd0 : p[i];
endmodule
