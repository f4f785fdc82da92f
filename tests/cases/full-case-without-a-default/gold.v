// The attribute full_case changes nothing: y keeps its value where s is 3.
module t(input [1:0] s, output reg y);
  always @*
    (* full_case *) case (s)
      0: y = 0;
      1: y = 1;
      2: y = 0;
    endcase
endmodule
