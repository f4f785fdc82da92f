// Two are read, one is written; or all are. No reset: what they hold is written before it is read.
module register_file (
    input  wire         clock,
    input  wire         fill,
    input  wire [511:0] line,
    input  wire         write,
    input  wire [3:0]   target,
    input  wire [31:0]  data,
    input  wire [3:0]   source_a,
    input  wire [3:0]   source_b,
    output wire [31:0]  a,
    output wire [31:0]  b,
    output wire [511:0] held
);
  reg [31:0] r [0:15];

  assign a = r[source_a];
  assign b = r[source_b];

  genvar g;
  generate
    for (g = 0; g < 16; g = g + 1) begin : each
      assign held[32*g +: 32] = r[g];
      always @(posedge clock)
        if (fill) r[g] <= line[32*g +: 32];
        else if (write & target == g) r[g] <= data;
    end
  endgenerate
endmodule
