// One instruction of RV32I, from the registers that it reads and the word that it loads.
//
// All of RV32I is there. FENCE does nothing, for there is one bus. ECALL and EBREAK trap, and so do
// every other code, a jump or a branch taken to an address that is no multiple of 4, and a load or
// a store that is not aligned to its size. An instruction that traps changes no register and no
// memory, and the next one is at TRAP_PC. There are no CSRs: a program cannot find out what
// trapped, or where.
//
// FAULT 1 and 2 plant faults: SRA by 31 shifts in zeros; a signed comparison is the sign of the
// difference.
module execute #(
    parameter FAULT = 0,
    parameter [31:0] TRAP_PC = 32'h00000004
) (
    input  wire [31:0] insn,
    input  wire [31:0] pc,
    input  wire [31:0] a,        // x[rs1]
    input  wire [31:0] b,        // x[rs2]
    input  wire [31:0] rdata,    // the word at mem_addr
    output wire        trap,
    output wire [ 4:0] rd,       // 0: no register is written
    output wire [31:0] rd_data,  // 0 where rd is 0
    output wire [31:0] next_pc,
    output wire [31:0] mem_addr, // of a word; 0 where no memory is used
    output wire [ 3:0] rmask,    // the bytes that are loaded, byte 0 is the lowest
    output wire [ 3:0] wmask,    // the bytes that are stored
    output wire [31:0] wdata     // 0 in all other bytes
);
  localparam [4:0] LOAD = 5'h00, FENCE = 5'h03, OP_IMM = 5'h04, AUIPC = 5'h05, STORE = 5'h08,
                   OP = 5'h0c, LUI = 5'h0d, BRANCH = 5'h18, JALR = 5'h19, JAL = 5'h1b;

  wire [4:0] opcode = insn[6:2];
  wire [2:0] funct3 = insn[14:12];
  wire [6:0] funct7 = insn[31:25];
  wire is_load   = opcode == LOAD;
  wire is_store  = opcode == STORE;
  wire is_op     = opcode == OP;
  wire is_branch = opcode == BRANCH;

  wire [31:0] imm_i = {{20{insn[31]}}, insn[31:20]};
  wire [31:0] imm_s = {{20{insn[31]}}, insn[31:25], insn[11:7]};
  wire [31:0] imm_b = {{20{insn[31]}}, insn[7], insn[30:25], insn[11:8], 1'b0};
  wire [31:0] imm_u = {insn[31:12], 12'd0};
  wire [31:0] imm_j = {{12{insn[31]}}, insn[19:12], insn[20], insn[30:21], 1'b0};

  // Whether RV32I has this instruction.
  reg is_known;
  always @*
    case (opcode)
      LOAD:     is_known = funct3 != 3'd3 && funct3 < 3'd6;
      STORE:    is_known = funct3 < 3'd3;
      BRANCH:   is_known = funct3[2:1] != 2'd1;
      JALR, FENCE: is_known = funct3 == 3'd0;
      OP_IMM:   is_known = funct3 == 3'd1 ? funct7 == 7'h00
                         : funct3 == 3'd5 ? funct7 == 7'h00 || funct7 == 7'h20 : 1'b1;
      OP:       is_known = funct7 == 7'h00 || (funct7 == 7'h20 && (funct3 == 3'd0 || funct3 == 3'd5));
      AUIPC, LUI, JAL: is_known = 1'b1;
      default:  is_known = 1'b0;
    endcase

  // Arithmetic.
  wire [31:0] right = insn[5] ? b : imm_i;  // of OP and BRANCH, or OP_IMM
  wire [31:0] difference = a - right;
  wire less_unsigned = a < right;
  wire less = FAULT == 2 ? difference[31] : a[31] != right[31] ? a[31] : less_unsigned;
  wire [4:0] shamt = right[4:0];
  wire fill = insn[30] && a[31] && !(FAULT == 1 && shamt == 5'd31);
  wire [31:0] shifted = a >> shamt | (fill ? ~(32'hffffffff >> shamt) : 32'd0);
  reg [31:0] computed;
  always @*
    case (funct3)
      3'd0: computed = is_op && insn[30] ? difference : a + right;
      3'd1: computed = a << shamt;
      3'd2: computed = {31'd0, less};
      3'd3: computed = {31'd0, less_unsigned};
      3'd4: computed = a ^ right;
      3'd5: computed = shifted;
      3'd6: computed = a | right;
      3'd7: computed = a & right;
    endcase

  // Jumps.
  wire is_equal = a == b;
  wire holds = (funct3[2] ? (funct3[1] ? less_unsigned : less) : is_equal) != funct3[0];
  wire jumps = opcode == JAL || opcode == JALR || (is_branch && holds);
  wire [31:0] target = opcode == JAL ? pc + imm_j
                     : opcode == JALR ? (a + imm_i) & ~32'd1 : pc + imm_b;
  wire [31:0] following = pc + 32'd4;

  // Memory.
  wire uses_memory = is_load || is_store;
  wire [31:0] address = a + (is_store ? imm_s : imm_i);
  wire [4:0] offset = {address[1:0], 3'd0};  // of the lowest byte, in bits
  wire [1:0] size = funct3[1:0];             // 1, 2 or 4 bytes
  wire [3:0] bytes = size == 2'd0 ? 4'b0001 : size == 2'd1 ? 4'b0011 : 4'b1111;
  wire [3:0] mask = bytes << address[1:0];
  wire is_misaligned = uses_memory && ((size[0] && address[0]) || (size[1] && address[1:0] != 2'd0));
  wire [31:0] loaded = rdata >> offset;
  wire is_signed = !funct3[2];
  wire [31:0] extended = size == 2'd0 ? {{24{is_signed && loaded[7]}}, loaded[7:0]}
                       : size == 2'd1 ? {{16{is_signed && loaded[15]}}, loaded[15:0]} : loaded;

  assign trap = insn[1:0] != 2'b11 || !is_known || (jumps && target[1]) || is_misaligned;
  assign next_pc = trap ? TRAP_PC : jumps ? target : following;
  assign rd = trap || is_store || is_branch || opcode == FENCE ? 5'd0 : insn[11:7];
  assign rd_data = rd == 5'd0 ? 32'd0
                 : is_load ? extended
                 : opcode == LUI ? imm_u
                 : opcode == AUIPC ? pc + imm_u
                 : opcode == JAL || opcode == JALR ? following : computed;
  assign mem_addr = uses_memory && !trap ? {address[31:2], 2'd0} : 32'd0;
  assign rmask = is_load && !trap ? mask : 4'd0;
  assign wmask = is_store && !trap ? mask : 4'd0;
  assign wdata = (b << offset) & {{8{wmask[3]}}, {8{wmask[2]}}, {8{wmask[1]}}, {8{wmask[0]}}};
endmodule
