// A default before a unique case.
module t(input [1:0] s, input [3:0] a, output logic [3:0] y);
  always_comb begin
    y = '0;
    unique case (s)
      2'd0: y = a;
      2'd1: y = ~a;
      2'd2, 2'd3: ;
    endcase
  end
endmodule
