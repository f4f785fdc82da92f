// Ports have the names of keywords.
module t(input \reg , output \wire ); assign \wire = ~\reg ; endmodule
