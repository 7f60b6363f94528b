#version 3.7;
height_field {
  png "there_is_no_such_picture.png" smooth
}
