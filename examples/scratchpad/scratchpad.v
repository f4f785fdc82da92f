// Sixteen registers of 32 bits beside a memory of lines of 512: a line fills them all in one clock,
// and all are saved as a line in one clock. Between that they are read and written one by one.
module scratchpad (
    input  wire         clock,
    input  wire         resetn,
    input  wire         fill,    // from line
    input  wire [511:0] line,
    input  wire         save,    // to saved
    output reg  [511:0] saved,
    output reg          fresh,   // saved is what the registers hold
    input  wire         write,
    input  wire [3:0]   target,
    input  wire [31:0]  data,
    input  wire [3:0]   source_a,
    input  wire [3:0]   source_b,
    output wire [31:0]  a,
    output wire [31:0]  b
);
  wire [511:0] held;

  register_file registers (
      .clock(clock), .fill(fill), .line(line), .write(write), .target(target), .data(data),
      .source_a(source_a), .source_b(source_b), .a(a), .b(b), .held(held));

  always @(posedge clock)
    if (!resetn) begin
      saved <= 512'd0;
      fresh <= 1'b0;
    end else begin
      if (save) saved <= held;
      fresh <= (fresh | save) & !fill & !write;
    end
endmodule
