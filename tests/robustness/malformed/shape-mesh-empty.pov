#version 3.7;
mesh {
}
