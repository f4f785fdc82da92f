// A queue of four between two clocks, whose reader takes the falling edge. FAULT=1: the writer takes one word more
// than there is room for, which only shows while the reader is slower.
module crosses #(
    parameter FAULT = 0
) (
    input  wire       fast,
    input  wire       slow,
    input  wire       rst,
    input  wire       x_valid,
    output wire       x_ready,
    input  wire [7:0] x_data,
    output wire       y_valid,
    input  wire       y_ready,
    output wire [7:0] y_data
);
  reg [7:0] store[0:3];
  reg [2:0] in, in_first, in_seen, out, out_first, out_seen;
  wire [2:0] held = in - out_seen;
  assign x_ready = held < (FAULT ? 5 : 4);
  assign y_valid = out != in_seen;
  assign y_data  = store[out[1:0]];

  always @(posedge fast) begin
    out_first <= rst ? 3'd0 : out;
    out_seen  <= rst ? 3'd0 : out_first;
    if (rst) in <= 0;
    else if (x_valid && x_ready) begin
      store[in[1:0]] <= x_data;
      in <= in + 3'd1;
    end
  end
  always @(negedge slow) begin
    in_first <= rst ? 3'd0 : in;
    in_seen  <= rst ? 3'd0 : in_first;
    if (rst) out <= 0;
    else if (y_valid && y_ready) out <= out + 3'd1;
  end
endmodule
