#version 3.7;
#declare A = datetime(1.5);
#declare B = datetime(1.5, "");
