module t(input c, r, a,b, output logic y);  assign y = a & b; endmodule
