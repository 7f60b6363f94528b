#version 3.7;
#debug "a tab\t\n"
#debug "not an \q escape\n"
