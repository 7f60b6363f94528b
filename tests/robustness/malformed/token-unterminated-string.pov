#version 3.7;
#debug "this is fine\n"
#debug "this never ends
sphere { 0, 1 }
