// Counts to nine. Its model does the same, so that only what it asserts itself can show that with
// FAULT it goes on to ten.
module asserted #(parameter FAULT = 0) (
    input  logic       clk, rst,
    input  logic       en,
    output logic [3:0] count
);
  always_ff @(posedge clk) begin
    if (rst) count <= 0;
    else if (en) count <= count == 9 + FAULT ? 0 : count + 1;
    assert (count <= 9) else $error("count is %0d", count);
  end
endmodule
