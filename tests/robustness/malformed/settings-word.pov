#version 3.7;
global_settings {
  max_trace_level 5
  max_recursion 7
}
