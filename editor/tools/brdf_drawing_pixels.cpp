// The pixels of the BRDF viewer that the CPU evaluates.
#include <algorithm>
#include <cmath>

#include "editor/tools/brdf_drawing.h"
#include "editor/view/view_camera.h"
#include "renderer/studies/angles.h"

namespace editor {

using reflectance::Vec3f;

/// Shades rows of a pass on the CPU, from the normals that the GPU drew.
void BrdfDrawing::add_on_cpu(BrdfLayers& layers, const Pass& pass, int first_row, int rows) {
  const int width = layers.size().width();
  const int height = layers.size().height();
  const int top = height - first_row - rows;  // rows of OpenGL start at the bottom
  const QRect place(0, first_row, width, rows);
  const std::vector<float> normals = layers.read_normals(place);
  const ViewCamera camera(scene_.view);
  std::vector<studies::SurfacePixel> pixels(normals.size() / 4);
  const auto from_below = [&](std::size_t i) {
    const auto w = static_cast<std::size_t>(width);
    return (static_cast<std::size_t>(rows) - 1 - i / w) * w + i % w;
  };
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const float* n = &normals[4 * from_below(i)];
    if (n[3] == 0) continue;
    const auto column = static_cast<double>(i % static_cast<std::size_t>(width));
    const auto row = static_cast<double>(i / static_cast<std::size_t>(width)) + top;
    const double x = (column + 0.5 + pass.shift.x) / width * 2 - 1;
    const double y = 1 - (row + 0.5 - pass.shift.y) / height * 2;
    pixels[i] = {{n[0], n[1], n[2]}, -Vec3f(camera.ray({x, y}, scene_.aspect()).direction.normalized())};
  }
  const auto image = studies::shade(pixels, width, top, *scene_.brdfs[0], *scene_.brdfs[1],
                                    scene_.split_column(width), scene_.lighting, pass.first, pass.count, {});
  std::vector<float> sum = layers.read_radiance(place);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (pixels[i].normal == Vec3f(0)) continue;
    float* shown = &sum[4 * from_below(i)];
    for (int k = 0; k < 3; ++k) shown[k] += image[i][k];
    shown[3] += 1;
  }
  layers.set_radiance(place, sum);
}

void BrdfDrawing::read_normals() {
  const std::vector<float> values = full_->read_normals({{0, 0}, scene_.size});
  auto image = std::make_shared<NormalImage>();
  image->size = scene_.size;
  for (int row = scene_.size.height() - 1; row >= 0; --row) {
    for (int column = 0; column < scene_.size.width(); ++column) {
      const float* n =
          &values[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(scene_.size.width()) +
                       static_cast<std::size_t>(column))];
      image->normals.emplace_back(n[0], n[1], n[2]);
    }
  }
  normals_ = std::move(image);
}

PixelProbe BrdfDrawing::probe(const QPoint& pixel) {
  PixelProbe probe;
  probe.pixel = pixel;
  const int row = scene_.size.height() - 1 - pixel.y();
  if (!scene_.object || !QRect({0, 0}, scene_.size).contains(pixel)) return probe;
  if (!probe_) probe_ = std::make_unique<BrdfLayers>(gl_, scene_.size);
  const QRect place(pixel.x(), row, 1, 1);
  gl_.glEnable(GL_SCISSOR_TEST);
  gl_.glScissor(place.x(), place.y(), 1, 1);
  const Pass all = {0, scene_.samples()};
  draw_normals(*probe_, all);
  gl_.glDisable(GL_SCISSOR_TEST);
  const std::vector<float> normal = probe_->read_normals(place);
  probe.normal = {normal[0], normal[1], normal[2]};
  probe.is_object = normal[3] > 0;
  probe.is_first = pixel.x() < scene_.split_column(scene_.size.width());
  if (!probe.is_object) return probe;
  const double x = (pixel.x() + 0.5) / scene_.size.width() * 2 - 1;
  const double y = 1 - (pixel.y() + 0.5) / scene_.size.height() * 2;
  const Vec3f to_eye = scene_.to_eye(x, y);
  probe.view_angle = std::acos(std::clamp(probe.normal.dot(to_eye), -1.0F, 1.0F)) / studies::Degree;
  probe.by_cpu = studies::reflected_radiance(scene_.brdf_at(pixel.x()), scene_.lighting, probe.normal, to_eye,
                                             {pixel.x(), pixel.y()}, 0, all.count);
  probe.by_gpu = probe.by_cpu;
  if (!is_by_glsl()) return probe;
  probe_->begin_radiance();
  gl_.glEnable(GL_SCISSOR_TEST);
  gl_.glScissor(place.x(), place.y(), 1, 1);
  probe_->clear_radiance();
  gl_.glEnable(GL_BLEND);
  gl_.glBlendFunc(GL_ONE, GL_ONE);
  add_brdf(*probe_, scene_.brdf_at(pixel.x()), all);
  gl_.glDisable(GL_BLEND);
  gl_.glDisable(GL_SCISSOR_TEST);
  const std::vector<float> radiance = probe_->read_radiance(place);
  probe.by_gpu = {radiance[0], radiance[1], radiance[2]};
  return probe;
}

}  // namespace editor
