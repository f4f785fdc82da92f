// An SPI master, mode 0: sends a byte, the highest bit first, and takes one meanwhile.
module spi (
    input  wire       clk,
    input  wire       rst,
    input  wire       send_valid,
    input  wire [7:0] send_data,
    output wire       send_ready,
    output reg        got_valid,
    output wire [7:0] got_data,
    output wire       cs_n,
    output reg        sclk,
    output wire       mosi,
    input  wire       miso
);
  reg busy;
  reg [7:0] shift;
  reg [2:0] bits;
  assign send_ready = !busy;
  assign cs_n = !busy;
  assign mosi = shift[7];
  assign got_data = shift;
  reg sampled;
  always @(posedge clk) begin
    got_valid <= 0;
    if (rst) begin
      busy <= 0;
      sclk <= 0;
    end else if (!busy) begin
      if (send_valid) begin
        busy <= 1;
        shift <= send_data;
        bits <= 0;
      end
    end else begin
      sclk <= !sclk;
      if (!sclk) sampled <= miso;
      else begin
        shift <= {shift[6:0], sampled};
        bits <= bits + 3'd1;
        if (bits == 3'd7) begin
          busy <= 0;
          got_valid <= 1;
        end
      end
    end
  end
endmodule
