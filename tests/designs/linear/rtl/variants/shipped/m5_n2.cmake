variant("As shipped, for comparison" M=5 N=2)
