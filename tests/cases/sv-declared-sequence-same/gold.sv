// A sequence and a property are declared and asserted.
module t(input c, r, a,b, output logic y); sequence s; a ##1 b; endsequence property p; @(posedge c) s |=> !r; endproperty assert property (p); assign y = a & b; endmodule
