// An assertion has its clock and its reset by default.
module t(input c, r, a,b, output logic y); default clocking cb @(posedge c); endclocking default disable iff (r); assert property (a |-> b); assign y = a & b; endmodule
