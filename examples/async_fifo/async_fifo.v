// A queue of 2^BITS words between two clocks: a word moves where valid and ready are both set as the clock
// of that side rises. Each side counts its words, and has the other's count as it was some clocks ago:
// in Gray code, of which one bit changes at a time, through two flip-flops.
module async_fifo #(parameter WIDTH = 8, parameter BITS = 3) (
    input  wire             rst_n,
    input  wire             w_clk,
    input  wire             w_valid,
    output wire             w_ready,
    input  wire [WIDTH-1:0] w_data,
    input  wire             r_clk,
    output wire             r_valid,
    input  wire             r_ready,
    output wire [WIDTH-1:0] r_data
);
  reg [WIDTH-1:0] store [0:(1<<BITS)-1];
  reg [BITS:0]    w_count;            // words that went in
  reg [BITS:0]    w_gray;
  reg [BITS:0]    r_first, r_seen;    // r_gray, at the writer
  reg [BITS:0]    r_count;            // words that came out
  reg [BITS:0]    r_gray;
  reg [BITS:0]    w_first, w_seen;    // w_gray, at the reader

  wire            push = w_valid & w_ready;
  wire            pop  = r_valid & r_ready;
  wire [BITS:0]   w_next = w_count + {{BITS{1'b0}}, push};
  wire [BITS:0]   r_next = r_count + {{BITS{1'b0}}, pop};

  // As many words more than seen as there are places: in Gray code the first two bits differ.
  assign w_ready = w_gray != {~r_seen[BITS:BITS-1], r_seen[BITS-2:0]};
  assign r_valid = r_gray != w_seen;
  assign r_data  = store[r_count[BITS-1:0]];

  always @(posedge w_clk) begin
    if (push) store[w_count[BITS-1:0]] <= w_data;
  end
  always @(posedge w_clk or negedge rst_n) begin
    if (!rst_n) begin
      w_count <= 0;
      w_gray  <= 0;
      r_first <= 0;
      r_seen  <= 0;
    end else begin
      w_count <= w_next;
      w_gray  <= w_next ^ (w_next >> 1);
      r_first <= r_gray;
      r_seen  <= r_first;
    end
  end
  always @(posedge r_clk or negedge rst_n) begin
    if (!rst_n) begin
      r_count <= 0;
      r_gray  <= 0;
      w_first <= 0;
      w_seen  <= 0;
    end else begin
      r_count <= r_next;
      r_gray  <= r_next ^ (r_next >> 1);
      w_first <= w_gray;
      w_seen  <= w_first;
    end
  end
endmodule
