// Only Verilator simulates it: Icarus Verilog 11 does not know streaming.
module t(input logic clk, rst_n, input logic [3:0] d, output logic [3:0] q);
  always_ff @(negedge rst_n, posedge clk)
    if (!rst_n) q <= 4'ha;
    else q <= {<<{d}};
endmodule
