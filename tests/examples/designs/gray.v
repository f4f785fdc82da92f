// A Gray counter with an asynchronous reset, active low, and a count of its clocks that no reset
// reaches. The delays are left out by all that read them.
module gray #(parameter FAULT = 0) (
    input  wire       clock, rst_n, en,
    output wire [3:0] code,
    output reg        odd,
    output wire [3:0] clocks
);
  reg [3:0] count, all;
  assign code   = count ^ (count >> 1);
  assign clocks = all;
  always @(posedge clock or negedge rst_n)
    if (!rst_n) count <= 4'd3;
    else if (en) count <= count + 4'd1;
  wire rst = !rst_n;
  always @(posedge clock or posedge rst)
    if (rst) odd <= #1 1'b0;
    else if (en) odd <= #1 !odd ^ (FAULT != 0 && count == 4'd12);
  always @(posedge clock) all <= #1 all + {3'b000, en};
endmodule
