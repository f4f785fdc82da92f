// A level of one clock that another clock's registers follow: always one of two is set. It comes through
// two flip-flops; the fault is that both registers sample it themselves. Each side has a reset, at once.
module unsynced #(parameter FAULT = 0) (
    input  wire a_clk, a_rst_n, turn, b_clk, b_rst,
    output wire works
);
  reg level;
  reg first, second;
  reg idle, busy;
  wire level_here = FAULT != 0 ? level : second;
  assign works = busy;

  always @(posedge a_clk or negedge a_rst_n) begin
    if (!a_rst_n) level <= 1'b0;
    else level <= level ^ turn;
  end
  always @(posedge b_clk or posedge b_rst) begin
    if (b_rst) begin
      first  <= 1'b0;
      second <= 1'b0;
      idle   <= 1'b1;
      busy   <= 1'b0;
    end else begin
      first  <= level;
      second <= first;
      idle   <= ~level_here;
      busy   <= level_here;
    end
  end
  always @* one_of_two: assert (idle != busy);
endmodule
