module t(input logic clk, a, input logic [31:0] d, output logic y);
  always_ff @(posedge clk) begin
    y <= a;
assert (d != 32'h600dcafe) else begin
      $error("d is %h", d);
      y <= 1;
    end
  end
endmodule
