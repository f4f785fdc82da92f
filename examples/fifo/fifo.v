// A queue of DEPTH words: what goes in comes out in the same order. A word moves where valid and
// ready are both set.
module fifo #(parameter WIDTH = 8, parameter DEPTH = 4) (
    input  wire             clk,
    input  wire             rst,
    input  wire             in_valid,
    output wire             in_ready,
    input  wire [WIDTH-1:0] in_data,
    output wire             out_valid,
    input  wire             out_ready,
    output wire [WIDTH-1:0] out_data
);
  localparam BITS = $clog2(DEPTH);
  reg [WIDTH-1:0] store [0:DEPTH-1];
  reg [BITS-1:0]  head;   // the word that comes out next
  reg [BITS-1:0]  tail;   // where the next one goes
  reg [BITS:0]    count;  // words in the queue

  wire push = in_valid & in_ready;
  wire pop  = out_valid & out_ready;

  assign in_ready = count != DEPTH;
  assign out_valid = count != 0;
  assign out_data  = store[head];

  always @(posedge clk) begin
    if (push) store[tail] <= in_data;
    if (rst) begin
      head  <= 0;
      tail  <= 0;
      count <= 0;
    end else begin
      if (pop) head <= head == DEPTH - 1 ? 0 : head + 1;
      if (push) tail <= tail == DEPTH - 1 ? 0 : tail + 1;
      count <= count + push - pop;
    end
  end
endmodule
