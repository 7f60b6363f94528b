#version 3.7;
#macro Inner(R)
  sphere {
    0,
    R + x.foo
  }
#end
#macro Outer(R)
  union {
    Inner(R)
    Inner(2)
  }
#end
Outer(3)
