// Two asynchronous resets: one of all that counts, active low, one of a lap alone. What the lap was when
// it ended is reset at the edge.
module laps #(parameter FAULT = 0) (
    input  wire       clk, rst_n, lap, en,
    output wire [5:0] clocks,
    output wire [3:0] since, longest
);
  reg [5:0] count;
  reg [3:0] part, most;
  assign clocks  = count;
  assign since   = part;
  assign longest = most;
  always @(posedge clk or negedge rst_n)
    if (!rst_n) count <= 6'd0;
    else if (en) count <= count + 6'd1;
  always @(posedge clk or posedge lap)
    if (lap) part <= 4'd1;
    else part <= part + {3'd0, en} + {3'd0, FAULT != 0 && count == 6'd21 && !en};
  always @(posedge clk)
    if (!rst_n) most <= 4'd0;
    else if (part > most) most <= part;
endmodule
