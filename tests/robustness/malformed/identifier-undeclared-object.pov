#version 3.7;
#declare Pillar = cylinder { 0, y, 1 }
object { Pilar translate x }
