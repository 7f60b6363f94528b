#version 3.7;
blob {
  threshold 0.5
  sphere { 0, 1, 1 }
  box { 0, 1 }
}
