#version 3.7;
#debug concat("The answer is ", str(42, 0, 0), "\n")
#debug 42
