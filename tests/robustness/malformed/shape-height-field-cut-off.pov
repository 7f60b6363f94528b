#version 3.7;
height_field { png "cut-off.png"
  smooth }
