// The value that is set before the case stays where no item is met.
module t(input logic [1:0] a, output logic y); always_comb begin y=0; unique case (a) 2'd1: y=1; 2'd2: y=1; endcase end endmodule
