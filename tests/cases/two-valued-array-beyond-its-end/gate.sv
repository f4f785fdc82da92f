module t(input logic clk, input logic [2:0] i, input logic d, output logic y);
  bit [4:0] m;
  bit [7:0] all;
  always_ff @(posedge clk) begin
    m <= {d ^ all[i], m[4:1]};
    all <= {all[6:0], d};
  end
  assign y = i < 5 ? m[i[2:0]] : 1'b1;
endmodule
