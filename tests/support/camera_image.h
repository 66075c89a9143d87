// Images are tested at known points of their scene.
#pragma once

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <gtest/gtest.h>

#include "renderer/image/image.h"

namespace test {

/// An image with its pinhole camera, y up.
class CameraImage {
 public:
  CameraImage(image::Image image, const Imath::V3d& eye, const Imath::V3d& target, double field_of_view)
      : image_(std::move(image)),
        eye_(eye),
        forward_((target - eye).normalized()),
        right_(forward_.cross(Imath::V3d(0, 1, 0)).normalized()),
        half_height_(std::tan(field_of_view * std::numbers::pi / 360)) {}

  /// Returns the pixel that shows a point of the scene.
  const grf::Colour& at(const Imath::V3d& place) const {
    const Imath::V3d way = place - eye_;
    const double scale = image_.height / (2 * half_height_ * way.dot(forward_));
    const double x = image_.width / 2.0 + scale * way.dot(right_);
    const double y = image_.height / 2.0 - scale * way.dot(right_.cross(forward_));
    if (!(x >= 0 && x < image_.width && y >= 0 && y < image_.height)) throw std::runtime_error("out of view");
    return image_.at(static_cast<int>(x), static_cast<int>(y));
  }
  const image::Image& image() const { return image_; }

 private:
  image::Image image_;
  Imath::V3d eye_;
  Imath::V3d forward_;
  Imath::V3d right_;
  double half_height_;
};

inline bool is_grey(const grf::Colour& pixel) {
  return std::abs(pixel.x - pixel.y) <= 1e-4F * pixel.x && std::abs(pixel.x - pixel.z) <= 1e-4F * pixel.x;
}

/// Checks the published view of samples/cornell_box. A pixel of its light has the radiance in the file. The
/// walls' reflectances differ by factors of 11 and 4 between red and green, and their irradiance, indirect
/// light included, by less than 4 and 3. Beside the open box the image is black.
inline void expect_cornell_box(const image::Image& image) {
  const CameraImage picture(image, {278, 273, -800}, {278, 273, 0}, 39.3076);
  if (image.height >= 64) {  // else no pixel shows the lamp alone
    const grf::Colour lamp = picture.at({278, 548.8, 279.5});
    EXPECT_LT((lamp - grf::Colour(16.86F, 9.9F, 3.6F)).length(), 0.02F);
  }
  const grf::Colour left = picture.at({552, 300, 280});
  EXPECT_GT(left.x, 0.01F);
  EXPECT_GT(left.x, 3 * left.y);
  const grf::Colour right = picture.at({0.5, 300, 280});
  EXPECT_GT(right.y, 0.005F);
  EXPECT_GT(right.y, 1.3F * right.x);
  if (image.width >= 1.25 * image.height) {
    EXPECT_EQ(image.at(0, image.height / 2), grf::Colour(0));
  }
}

}  // namespace test
