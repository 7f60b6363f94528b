#version 3.7;
sphere { 0, 1 }
/* this comment
   /* nests */
   and never ends
plane { y, 0 }
