// A core for RV32I that takes an instruction at a time: it fetches, executes, and then retires it.
//
// An access to the bus passes on a clock on which bus_valid and bus_ready are high; until then its
// address and data stay. bus_fetch is 1 where it reads an instruction. A retirement is reported on
// the one clock on which retired_valid is 1; mem_data is the word that was read, or stored.
//
// FAULT 3 plants a fault: a load writes its register while it still waits.
module core #(parameter FAULT = 0) (
    input  wire        clk,
    input  wire        rst,
    output wire        bus_valid,
    output wire        bus_fetch,
    output wire [31:0] bus_addr,   // a multiple of 4
    output wire [ 3:0] bus_wmask,  // the bytes that are stored; 0: it reads
    output wire [31:0] bus_wdata,
    input  wire        bus_ready,
    input  wire [31:0] bus_rdata,
    output reg         retired_valid,
    output reg  [31:0] retired_order, // instructions retired before it
    output reg  [31:0] retired_insn,
    output reg         retired_trap,
    output reg  [31:0] retired_pc,
    output reg  [31:0] retired_next_pc,
    output reg  [ 4:0] retired_rd,
    output reg  [31:0] retired_rd_data,
    output reg  [31:0] retired_mem_addr,
    output reg  [ 3:0] retired_rmask,
    output reg  [ 3:0] retired_wmask,
    output reg  [31:0] retired_mem_data
);
  reg [31:0] x [1:31];
  reg [31:0] pc, insn, count;
  reg executing;  // insn; or it is being fetched

  wire [4:0] rs1 = insn[19:15], rs2 = insn[24:20];
  wire [4:0] rd;
  wire [31:0] rd_data, next_pc, mem_addr, wdata;
  wire [3:0] rmask, wmask;
  wire trap;
  execute #(.FAULT(FAULT)) executes (
      .insn(insn), .pc(pc), .a(rs1 == 5'd0 ? 32'd0 : x[rs1]), .b(rs2 == 5'd0 ? 32'd0 : x[rs2]),
      .rdata(bus_rdata), .trap(trap), .rd(rd), .rd_data(rd_data), .next_pc(next_pc),
      .mem_addr(mem_addr), .rmask(rmask), .wmask(wmask), .wdata(wdata));

  wire uses_memory = (rmask | wmask) != 4'd0;
  assign bus_valid = !rst && (!executing || uses_memory);
  assign bus_fetch = !executing;
  assign bus_addr  = executing ? mem_addr : pc;
  assign bus_wmask = executing ? wmask : 4'd0;
  assign bus_wdata = executing ? wdata : 32'd0;
  wire retires = executing && (!uses_memory || bus_ready);

  integer i;
  always @(posedge clk)
    if (rst) begin
      executing <= 1'b0;
      pc <= 32'd0;
      count <= 32'd0;
      retired_valid <= 1'b0;
      for (i = 1; i < 32; i = i + 1) x[i] <= 32'd0;
    end else begin
      if (!executing && bus_ready) insn <= bus_rdata;
      executing <= executing ? !retires : bus_ready;
      if ((FAULT == 3 ? executing : retires) && rd != 5'd0) x[rd] <= rd_data;
      if (retires) begin
        pc <= next_pc;
        count <= count + 32'd1;
      end
      retired_valid    <= retires;
      retired_order    <= count;
      retired_insn     <= insn;
      retired_trap     <= trap;
      retired_pc       <= pc;
      retired_next_pc  <= next_pc;
      retired_rd       <= rd;
      retired_rd_data  <= rd_data;
      retired_mem_addr <= mem_addr;
      retired_rmask    <= rmask;
      retired_wmask    <= wmask;
      retired_mem_data <= rmask != 4'd0 ? bus_rdata : wdata;
    end
endmodule
