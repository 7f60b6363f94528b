#version 3.7;
#ifdef (Nothing)
  something ignored
  grün
#end
