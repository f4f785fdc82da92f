// foreach, ++ and += over an unpacked array.
module t(input [7:0] a, output logic [3:0] y);
  logic [1:0] u [4];
  always_comb begin
    int n;
    n = 0;
    y = 0;
    foreach (u[i]) begin
      u[i] = a[2*i +: 2];
      y += u[i];
      n++;
    end
    y += n;
  end
endmodule
