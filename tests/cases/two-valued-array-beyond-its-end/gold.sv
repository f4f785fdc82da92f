module t(input logic clk, input logic [2:0] i, input logic d, output logic y);
  localparam int LAST = 4;
  bit m[5];
  bit [7:0] all;
  always_ff @(posedge clk) begin
    for (int k = 0; k < 4; k++) m[k] <= m[k + 1];
    m[LAST] <= d ^ all[i];
    all <= {all[6:0], d};
  end
  assign y = m[i];
endmodule
