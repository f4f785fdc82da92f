module t(input clk, input [1:0] s, input [15:0] d, e, output logic [15:0] y);
typedef enum logic [1:0] {A,B,C,D} st;
st q; assign q = st'(s);
always_ff @(posedge clk) case (q)
 A: y <= e;
 B: cover property (e != d);
 default: y <= d;
endcase
endmodule
