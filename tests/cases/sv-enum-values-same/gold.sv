// Values of an enum go on from the one before.
module t(input [2:0] a, output logic [2:0] y);
  typedef enum logic [2:0] {IDLE = 3'd2, RUN, STOP = 3'd6, LAST} state_t;
  always_comb
    case (a)
      IDLE: y = RUN;
      RUN: y = STOP;
      STOP: y = LAST;
      default: y = IDLE;
    endcase
endmodule
