// SHA-256, FIPS 180-4: blocks of 512 bits go in, padded already; after the last one of a message its
// digest comes out, and the next one begins. One round a clock; the message schedule stands in a register file of 16 words,
// each of which is replaced by the one 16 rounds on when it has been used.
module sha256 (
    input  wire         clk,
    input  wire         rst,
    input  wire         block_valid,
    output wire         block_ready,
    input  wire [511:0] block_data,   // the first word of the message in the highest bits
    input  wire         block_last,
    output wire         digest_valid,
    input  wire         digest_ready,
    output wire [255:0] digest_data
);
  localparam [1:0] IDLE = 0, ROUNDS = 1, ADD = 2, DONE = 3;
  localparam [255:0] START = {32'h6a09e667, 32'hbb67ae85, 32'h3c6ef372, 32'ha54ff53a, 32'h510e527f, 32'h9b05688c, 32'h1f83d9ab, 32'h5be0cd19};

  reg [1:0] phase;
  reg [5:0] round;
  reg       last, fresh;  // fresh: a message begins
  reg [31:0] w[0:15];
  reg [255:0] hash;
  reg [31:0] a, b, c, d, e, f, g, h;

  assign block_ready  = phase == IDLE;
  assign digest_valid = phase == DONE;
  assign digest_data  = hash;

  function [31:0] right(input [31:0] x, input integer n);
    right = (x >> n) | (x << (32 - n));
  endfunction

  reg [31:0] k;
  always @* begin
    k = 0;
    case (round)
      6'd0: k = 32'h428a2f98; 6'd1: k = 32'h71374491; 6'd2: k = 32'hb5c0fbcf; 6'd3: k = 32'he9b5dba5;
      6'd4: k = 32'h3956c25b; 6'd5: k = 32'h59f111f1; 6'd6: k = 32'h923f82a4; 6'd7: k = 32'hab1c5ed5;
      6'd8: k = 32'hd807aa98; 6'd9: k = 32'h12835b01; 6'd10: k = 32'h243185be; 6'd11: k = 32'h550c7dc3;
      6'd12: k = 32'h72be5d74; 6'd13: k = 32'h80deb1fe; 6'd14: k = 32'h9bdc06a7; 6'd15: k = 32'hc19bf174;
      6'd16: k = 32'he49b69c1; 6'd17: k = 32'hefbe4786; 6'd18: k = 32'h0fc19dc6; 6'd19: k = 32'h240ca1cc;
      6'd20: k = 32'h2de92c6f; 6'd21: k = 32'h4a7484aa; 6'd22: k = 32'h5cb0a9dc; 6'd23: k = 32'h76f988da;
      6'd24: k = 32'h983e5152; 6'd25: k = 32'ha831c66d; 6'd26: k = 32'hb00327c8; 6'd27: k = 32'hbf597fc7;
      6'd28: k = 32'hc6e00bf3; 6'd29: k = 32'hd5a79147; 6'd30: k = 32'h06ca6351; 6'd31: k = 32'h14292967;
      6'd32: k = 32'h27b70a85; 6'd33: k = 32'h2e1b2138; 6'd34: k = 32'h4d2c6dfc; 6'd35: k = 32'h53380d13;
      6'd36: k = 32'h650a7354; 6'd37: k = 32'h766a0abb; 6'd38: k = 32'h81c2c92e; 6'd39: k = 32'h92722c85;
      6'd40: k = 32'ha2bfe8a1; 6'd41: k = 32'ha81a664b; 6'd42: k = 32'hc24b8b70; 6'd43: k = 32'hc76c51a3;
      6'd44: k = 32'hd192e819; 6'd45: k = 32'hd6990624; 6'd46: k = 32'hf40e3585; 6'd47: k = 32'h106aa070;
      6'd48: k = 32'h19a4c116; 6'd49: k = 32'h1e376c08; 6'd50: k = 32'h2748774c; 6'd51: k = 32'h34b0bcb5;
      6'd52: k = 32'h391c0cb3; 6'd53: k = 32'h4ed8aa4a; 6'd54: k = 32'h5b9cca4f; 6'd55: k = 32'h682e6ff3;
      6'd56: k = 32'h748f82ee; 6'd57: k = 32'h78a5636f; 6'd58: k = 32'h84c87814; 6'd59: k = 32'h8cc70208;
      6'd60: k = 32'h90befffa; 6'd61: k = 32'ha4506ceb; 6'd62: k = 32'hbef9a3f7; 6'd63: k = 32'hc67178f2;
    endcase
  end

  wire [3:0]  at   = round[3:0];
  wire [31:0] w0   = w[at];
  wire [3:0]  at1  = at + 4'd1, at9 = at + 4'd9, at14 = at + 4'd14;
  wire [31:0] w1   = w[at1], w9 = w[at9], w14 = w[at14];
  wire [31:0] s0   = right(w1, 7) ^ right(w1, 18) ^ (w1 >> 3);
  wire [31:0] s1   = right(w14, 17) ^ right(w14, 19) ^ (w14 >> 10);
  wire [31:0] sum1 = right(e, 6) ^ right(e, 11) ^ right(e, 25);
  wire [31:0] sum0 = right(a, 2) ^ right(a, 13) ^ right(a, 22);
  wire [31:0] t1   = h + sum1 + ((e & f) ^ (~e & g)) + k + w0;
  wire [31:0] t2   = sum0 + ((a & b) ^ (a & c) ^ (b & c));

  integer i;
  always @(posedge clk)
    if (rst) begin
      phase <= IDLE;
      fresh <= 1'b1;
    end else
      case (phase)
        IDLE:
        if (block_valid) begin
          phase <= ROUNDS;
          round <= 0;
          last  <= block_last;
          fresh <= block_last;
          for (i = 0; i < 16; i = i + 1) w[i] <= block_data[511-32*i-:32];
          if (fresh) hash <= START;
          {a, b, c, d, e, f, g, h} <= fresh ? START : hash;
        end
        ROUNDS: begin
          w[at] <= w0 + s0 + w9 + s1;
          {a, b, c, d, e, f, g, h} <= {t1 + t2, a, b, c, d + t1, e, f, g};
          round <= round + 6'd1;
          if (round == 63) phase <= ADD;
        end
        ADD: begin
          phase <= last ? DONE : IDLE;
          hash <= {
            hash[255:224] + a, hash[223:192] + b, hash[191:160] + c, hash[159:128] + d,
            hash[127:96] + e, hash[95:64] + f, hash[63:32] + g, hash[31:0] + h
          };
        end
        DONE: if (digest_ready) phase <= IDLE;
      endcase
endmodule
