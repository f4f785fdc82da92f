// if and case in generate, over a parameter.
module below #(parameter K = 0)(input [1:0] a, output y);
  generate
    if (K == 0) begin : first
      assign y = a[0];
    end else case (K)
      1, 2: begin : second
        assign y = a[1];
      end
      default: assign y = ^a;
    endcase
  endgenerate
endmodule
module t(input [1:0] a, output [3:0] y);
  genvar i;
  generate
    for (i = 0; i < 4; i = i + 1) begin : one
      below #(.K(i)) u(a, y[i]);
    end
  endgenerate
endmodule
