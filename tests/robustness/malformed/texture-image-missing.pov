#version 3.7;
sphere {
  0, 1
  pigment {
    image_map { png "there_is_no_such_picture.png" }
  }
}
