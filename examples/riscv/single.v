// One instruction of RV32I on each clock: the instruction at pc and the word at mem_addr are inputs.
module single #(parameter FAULT = 0) (
    input  wire        clk,
    input  wire        rst,
    input  wire [31:0] insn,
    input  wire [31:0] rdata,
    output reg  [31:0] pc,
    output wire        trap,
    output wire [ 4:0] rd,
    output wire [31:0] rd_data,
    output wire [31:0] next_pc,
    output wire [31:0] mem_addr,
    output wire [ 3:0] rmask,
    output wire [ 3:0] wmask,
    output wire [31:0] wdata
);
  reg [31:0] x [1:31];
  wire [4:0] rs1 = insn[19:15], rs2 = insn[24:20];

  execute #(.FAULT(FAULT)) executes (
      .insn(insn), .pc(pc), .a(rs1 == 5'd0 ? 32'd0 : x[rs1]), .b(rs2 == 5'd0 ? 32'd0 : x[rs2]),
      .rdata(rdata), .trap(trap), .rd(rd), .rd_data(rd_data), .next_pc(next_pc),
      .mem_addr(mem_addr), .rmask(rmask), .wmask(wmask), .wdata(wdata));

  integer i;
  always @(posedge clk)
    if (rst) begin
      pc <= 32'd0;
      for (i = 1; i < 32; i = i + 1) x[i] <= 32'd0;
    end else begin
      pc <= next_pc;
      if (rd != 5'd0) x[rd] <= rd_data;
    end
endmodule
