// Skipped text is still read in tokens.
#version 3.7;
#if (0)
  sphere { @ $ "fine" }
  #debug "open
#end
