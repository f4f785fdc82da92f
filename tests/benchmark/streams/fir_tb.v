// The filter under Icarus Verilog: any sample, given and taken on random clocks, N clocks. Nothing is
// compared. Prints how many samples came out.
module fir_tb;
  parameter N = 1000;
  reg clk = 0, rst = 1, x_valid = 0, y_ready = 0;
  reg signed [11:0] x_data = 0;
  wire x_ready, y_valid;
  wire signed [16:0] y_data;
  integer taken = 0;
  fir #(.W(12), .STAGES(3)) dut (.clk(clk), .rst(rst), .x_valid(x_valid), .x_ready(x_ready),
    .x_data(x_data), .y_valid(y_valid), .y_ready(y_ready), .y_data(y_data));
  initial begin
    repeat (N) begin
      {x_valid, y_ready, x_data} = $random;
      #1 if (y_valid && y_ready) taken = taken + 1;
      clk = 1;
      #1 clk = 0;
      rst = 0;
    end
    $display("%0d", taken);
    $finish;
  end
endmodule
