variant("As shipped, for comparison" M=16 N=13)
