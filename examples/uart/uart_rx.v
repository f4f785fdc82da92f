// Receives bytes from a line: a start bit, eight data bits, the lowest first, a stop bit; each takes D
// clocks, 4 to 256.
module uart_rx #(parameter D = 4) (
    input  wire       clock,
    input  wire       rst_n,
    input  wire       rx,
    output wire       valid,  // for a clock: a byte has come
    output wire       error,  // for a clock: the same, but its stop bit is 0
    output wire [7:0] data
);
  reg [1:0] sync;   // rx is of another clock: two flip-flops, which no reset reaches
  reg [3:0] left;   // bits of the frame still to come
  reg [7:0] count;  // clocks to the middle of the next
  reg [8:0] frame;  // the last bits, the newest highest
  reg       done;

  wire line   = sync[1];
  wire start  = left == 4'd0 & !line;
  wire sample = left != 4'd0 & count == 8'd0;
  wire glitch = left == 4'd10 & line;  // no start bit after all

  assign data  = frame[7:0];
  assign valid = done & frame[8];
  assign error = done & !frame[8];

  always @(posedge clock) begin
    sync  <= {sync[0], rx};
    count <= start ? D / 2 - 1 : sample ? D - 1 : count - 8'd1;
    if (sample) frame <= {line, frame[8:1]};
    if (!rst_n) begin
      left <= 4'd0;
      done <= 1'b0;
    end else begin
      done <= sample & left == 4'd1;
      if (start) left <= 4'd10;
      else if (sample) left <= glitch ? 4'd0 : left - 4'd1;
    end
  end
endmodule
