#version 3.7;
#debug "continued \
here\n"
