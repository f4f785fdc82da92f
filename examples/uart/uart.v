// Sends bytes on a line: a start bit, eight data bits, the lowest first, a stop bit; each takes D
// clocks.
module uart #(parameter D = 4) (
    input  wire       clock,
    input  wire       rst_n,
    input  wire       valid,
    input  wire [7:0] data,
    output wire       ready,
    output wire       tx
);
  reg [3:0] left;   // bits of the frame still to come
  reg [8:0] frame;  // what is left of it, the next bit lowest
  wire accept = valid & ready;
  wire tick;

  uart_divider #(.D(D)) divider (
      .clock(clock), .restart(!rst_n | accept), .tick(tick));

  assign ready = left == 4'd0;
  assign tx    = ready | frame[0];

  always @(posedge clock)
    if (!rst_n) begin
      left <= 4'd0;
    end else if (accept) begin
      left  <= 4'd10;
      frame <= {data, 1'b0};
    end else if (tick & !ready) begin
      left  <= left - 4'd1;
      frame <= {1'b1, frame[8:1]};
    end
endmodule
