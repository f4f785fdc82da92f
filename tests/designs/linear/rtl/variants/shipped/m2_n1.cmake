variant("The narrowest there is" M=2 N=1)
