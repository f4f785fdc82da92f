variant("The fewest words of the most positions" M=7 N=1)
