// Two words, one behind the other, open it: no random clock does.
module lock #(parameter FAULT = 0) (
    input  wire        clk,
    input  wire        rst,
    input  wire [15:0] code,
    output wire        bell,
    output wire [3:0]  clocks
);
  reg       half_q, last_q, open_q;
  reg [3:0] clocks_q;
  wire both     = half_q & last_q;  // never: a clock has one word
  assign bell   = open_q & code[0] | both;
  assign clocks = clocks_q;
  always @(posedge clk)
    if (rst) begin
      half_q   <= 1'b0;
      last_q   <= 1'b0;
      open_q   <= 1'b0;
      clocks_q <= 4'd0;
    end else begin
      half_q   <= #1 code == 16'hc0de;
      last_q   <= code == 16'hbeef;
      open_q   <= open_q | half_q & code == 16'hbeef;
      clocks_q <= clocks_q + (FAULT != 0 && clocks_q == 4'd5 ? 4'd2 : 4'd1);
    end
  always @(posedge clk) if (!rst) cover (open_q && clocks_q == 4'd9);
endmodule
