// Takes a byte over one wire, a start bit, eight bits from the lowest on and a stop bit, and sends it
// on, plus one, the same way. The fault: 199 is sent as 201.
module serial #(parameter FAULT = 0) (
    input  wire clk,
    input  wire rst,
    input  wire rx,
    output wire busy,  // rx is to stay 1
    output reg  tx,
    input  wire go     // tx may begin
);
  reg receiving, full, sending;
  reg [3:0] in_bit, out_bit;
  reg [7:0] in, held, out;
  assign busy = receiving || full;
  always @(posedge clk)
    if (rst) begin
      receiving <= 0;
      full <= 0;
      sending <= 0;
      tx <= 1;
    end else begin
      if (!receiving) begin
        receiving <= !rx;
        in_bit <= 0;
      end else if (in_bit == 8) begin
        receiving <= 0;
        full <= 1;
        held <= in + (FAULT == 1 && in == 199 ? 8'd2 : 8'd1);
      end else begin
        in <= {rx, in[7:1]};
        in_bit <= in_bit + 4'd1;
      end
      if (!sending && full && go) begin
        sending <= 1;
        full <= 0;
        out <= held;
        out_bit <= 0;
        tx <= 0;
      end else if (sending) begin
        sending <= out_bit != 8;
        tx <= out_bit == 8 || out[0];
        out <= {1'b0, out[7:1]};
        out_bit <= out_bit + 4'd1;
      end
    end
endmodule
