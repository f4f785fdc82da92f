module t(input [3:0] clkless, input ck, a, b, c, rn, s, e, output [13:0] y, output [1:0] fa, output [6:0] q, output qn);
OPS o(.A(a),.B(b),.C(c),.Y0(y[0]),.Y1(y[1]),.Y2(y[2]),.Y3(y[3]),.Y4(y[4]),.Y5(y[5]),.Y6(y[6]),.Y7(y[7]),.Y8(y[8]),.Y9(y[9]),.Ya(y[10]),.Yb(y[11]),.Yc(y[12]),.Yd(y[13]));
FA f(.A(a),.B(b),.CI(c),.S(fa[0]),.CO(fa[1]));
DFF f0(.CK(ck),.D(a),.Q(q[0]),.QN(qn)); AND2 g(.A(a),.B(b),.Y(q[1])); DFFR f2(.CK(ck),.D(a),.RN(rn),.Q(q[2]));
DFFS f3(.CK(ck),.D(a),.S(s),.Q(q[3])); DFFE f5(.CK(ck),.D(b),.E(e),.Q(q[4])); assign q[6:5] = 0;
endmodule
