module drv(output y); assign y = 1; endmodule
module t(input a, output y); wire y2;  assign y = a & y2; endmodule
bind t drv d(.y());
