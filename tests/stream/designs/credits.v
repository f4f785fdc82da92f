// A store of four words with credits on both sides: whoever sends into it begins with four, and gets
// one back for each word that leaves; it begins with two for what it sends on.
module credits #(parameter FAULT = 0) (
    input  wire        clk, rst,
    input  wire        in_valid,
    input  wire [15:0] in_word,
    output reg         in_credit,
    output reg         out_valid,
    output reg  [15:0] out_word,
    input  wire        out_credit
);
  reg [15:0] store [0:3];
  reg [1:0] first, next;
  reg [2:0] held;
  reg [1:0] credit;
  // The fault: it sends its last credit twice when another one comes back on the same clock.
  wire sends = held != 0 && (credit != 0 || (FAULT == 1 && held == 4));
  always @(posedge clk)
    if (rst) begin
      first     <= 0;
      next      <= 0;
      held      <= 0;
      credit    <= 2;
      in_credit <= 0;
      out_valid <= 0;
    end else begin
      if (in_valid) begin
        store[next] <= in_word;
        next        <= next + 2'd1;
      end
      if (sends) begin
        out_word <= store[first];
        first    <= first + 2'd1;
      end
      out_valid <= sends;
      in_credit <= sends;
      held      <= held + {2'd0, in_valid} - {2'd0, sends};
      credit    <= credit + {1'b0, out_credit} - {1'b0, sends};
    end
endmodule
