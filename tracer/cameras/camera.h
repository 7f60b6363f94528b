// From a place on the picture to a ray (spec/shading.md 3.1, 3.3, 4.3).
#pragma once

#include <memory>

#include "tracer/cameras/mesh_camera.h"
#include "tracer/math/ray.h"
#include "tracer/scene/camera.h"
#include "tracer/texture/surface_texture.h"

namespace durer {

class Camera {
 public:
  // `textures` is used here only: it compiles the camera's normal.
  Camera(const CameraNode& node, int width, int height, const TextureSettings& textures);

  // x, y in pixels, (0.5, 0.5) the centre of the top left one; not clipped to the picture. False:
  // no ray here (outside a round image, beside a mesh). `ray_of_pixel`: which of rays_per_pixel().
  bool generate_ray(double x, double y, int ray_of_pixel, Ray& ray) const;
  // The same through a point of the lens, given in radii of the aperture, x to the right, y down.
  bool generate_lens_ray(double x, double y, const Vec2& lens, Ray& ray) const;

  // More than one only for mesh cameras; their mean is the pixel.
  int rays_per_pixel() const;
  bool has_lens() const { return node_.aperture != 0 && node_.blur_samples > 0; }
  // True if POV-Ray looks anew at every ray in which objects it starts; for other cameras it keeps
  // the answer for the first ray of the picture.
  bool looks_around_each_origin() const;
  const CameraNode& node() const { return node_; }

 private:
  // A ray before its direction is normalised, and where on the picture the normal is looked up.
  struct View {
    Vec3 origin, direction;
    Vec2 place{0};
  };
  bool view_of(double x, double y, int ray_of_pixel, View& view) const;
  // Shares of the picture from its left and bottom edge. Rounded as POV-Ray's: surfaces that coincide
  // and fractals depend on a ray's last bits.
  double share_of_width(double x) const { return x / width_; }
  double share_of_height(double y) const { return (height_ - y) / height_; }
  Vec3 perspective(double a, double b) const {
    return node_.direction + a * node_.right + b * node_.up;
  }
  bool view_of_fisheye(double a, double b, View& view) const;
  bool view_of_omnimax(double a, double b, View& view) const;
  Vec3 finished_direction(const Vec3& direction, const Vec2& place) const;

  CameraNode node_;
  double width_, height_;
  bool is_plain_;  // a perspective without a normal
  Vec3 direction_, right_, up_;  // unit vectors of direction, right, up
  double right_length_, up_length_;
  double angle_;               // radians
  Vec3 lens_right_, lens_up_;  // the aperture's radius long
  double focus_;               // focal distance in lengths of `direction`
  std::unique_ptr<const MeshCamera> mesh_;
  std::shared_ptr<const CompiledNormal> normal_;
};

}  // namespace durer
