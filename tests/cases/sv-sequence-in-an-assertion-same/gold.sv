// Neither Icarus Verilog nor Verilator reads the delay in the assertion, which changes nothing.
module t(input c, r, a,b, output logic y); lbl: assert property (@(posedge c) disable iff (r) a |-> ##[1:3] b) else $error("no"); assign y = a & b; endmodule
