// The receiver under Icarus Verilog: any value on its inputs, N clocks. Nothing is compared.
module uart_rx_tb;
  parameter N = 1000;
  reg clock = 0, rst_n = 0, rx = 1;
  wire valid, error;
  wire [7:0] data;
  uart_rx #(.D(16)) dut (.clock(clock), .rst_n(rst_n), .rx(rx), .valid(valid), .error(error), .data(data));
  initial begin
    repeat (N) begin
      {rst_n, rx} = $random;
      #1 clock = 1;
      #1 clock = 0;
    end
    $display("%0d", N);
    $finish;
  end
endmodule
