// Nets of every size and place: wider than 64 bits, slices, memories of narrow and of wide words, one
// whose first word is not 0, two instances of one module, one in a generate block. Several files,
// an include folder, a define.
module wires #(parameter FAULT = 0, parameter W = 65, parameter D = 4) (
    input  wire         clk, rst, write,
    input  wire [2:0]   index,
    input  wire [W-1:0] d,
    output wire [W-1:0] q,
    output wire [19:0]  mixed
);
  reg [W-1:0] held;
  reg [9:0]   status;           // two counters and a flag
  reg [127:0] lines [0:3];
  reg [4:0]   order [0:D-1];
  reg [3:0]   pair [7:6];
  wire [7:0]  from_a, from_b, from_c;

  assign q     = held;
  assign mixed = {from_c[3:0], from_b, from_a};

  wires_part a (.clk(clk), .d(d[7:0]), .q(from_a));
  wires_part b (.clk(clk), .d(from_a), .q(from_b));
  genvar g;
  generate
    for (g = 2; g < 3; g = g + 1) begin : more
      wires_part c (.clk(clk), .d(from_b ^ {3'd0, order[D-1]} ^ {4'd0, pair[7]}), .q(from_c));
    end
  endgenerate

  integer i;
  always @(posedge clk) begin
    held <= rst ? {W{1'b0}} : d;
    status[3:0] <= rst ? 4'd0 : status[3:0] + 4'd1;
    status[8:4] <= rst ? 5'd0 : status[8:4] + {4'd0, write};
    status[9] <= rst ? 1'b0 : lines[index[1:0]][127];
    if (write) pair[{2'b11, index[1]}] <= d[7:4];
    if (write) lines[index[1:0]] <= {d[27:0], d};
    for (i = 0; i < D; i = i + 1)
      if (rst) order[i] <= i;
      else if (write && index == i)
        order[i] <= d[4:0] ^ {5{FAULT != 0 && i == 3 && &d[W-1:W-2] && status[4]}};
  end
endmodule
