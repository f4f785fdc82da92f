// Four registers on an APB: 0 and 1 are written and read, 2 is their sum, and 3 counts the accesses
// before. Register 3 takes one wait state. Only the lower two address bits of words are decoded.
module apb (
    input  wire        pclk,
    input  wire        presetn,
    input  wire        psel,
    input  wire        penable,
    input  wire        pwrite,
    input  wire [ 3:0] paddr,
    input  wire [31:0] pwdata,
    output wire        pready,
    output reg  [31:0] prdata
);
  reg [31:0] a, b, accesses;
  reg waited;
  assign pready = psel && penable && (paddr[3:2] != 2'd3 || waited);
  always @*
    case (paddr[3:2])
      2'd0: prdata = a;
      2'd1: prdata = b;
      2'd2: prdata = a + b;
      2'd3: prdata = accesses;
    endcase
  always @(posedge pclk)
    if (!presetn) begin
      a <= 0;
      b <= 0;
      accesses <= 0;
      waited <= 0;
    end else begin
      waited <= psel && penable && !waited;
      if (pready) begin
        accesses <= accesses + 1;
        if (pwrite && paddr[3:2] == 2'd0) a <= pwdata;
        if (pwrite && paddr[3:2] == 2'd1) b <= pwdata;
      end
    end
endmodule
