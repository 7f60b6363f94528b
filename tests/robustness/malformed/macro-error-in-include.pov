#version 3.7;
#include "tower.inc"
Tower(3)
Tower("high")
