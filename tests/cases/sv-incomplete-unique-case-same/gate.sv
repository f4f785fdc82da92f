module t(input logic [1:0] a, output logic y); always_comb begin y=0; y = a==1||a==2; end endmodule
