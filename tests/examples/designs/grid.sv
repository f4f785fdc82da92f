// A memory of two dimensions. The fault is that a write to the last cell of a row also clears the first.
module grid #(parameter FAULT = 0) (
    input  logic       clk, rst, write, row,
    input  logic [1:0] column,
    input  logic [3:0] d,
    output logic [3:0] q
);
  logic [3:0] cells[0:1][0:2];

  always_ff @(posedge clk) begin
    if (write && column != 3) cells[row][column] <= d;
    if (FAULT != 0 && write && column == 2) cells[row][0] <= 0;
    q <= rst || column == 3 ? 0 : cells[row][column];
  end
endmodule
