variant("The narrowest there is" W=2)
