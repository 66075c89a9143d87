#include "renderer/command/brdf_plot.h"

#include <array>
#include <vector>

#include "renderer/command/lit_sphere.h"
#include "renderer/image/encoders.h"
#include "renderer/plot/brdf_charts.h"

namespace command {
namespace {

using reflectance::Reflector;

constexpr double Width = 980;
constexpr double Height = 660;
constexpr double SpectrumHeight = 300;
constexpr std::array<double, 4> Views = {0, 30, 60, 80};
constexpr int SphereSide = 200;

std::vector<plot::LobeCurve> lobe_curves(const Reflector& reflector) {
  std::vector<plot::LobeCurve> curves;
  for (const double view : Views) curves.push_back(plot::lobe_curve(reflector.brdf(), view));
  return curves;
}

}  // namespace

plot::Svg picture_of(const Reflector& reflector, const std::string& title) {
  const auto spectrum = plot::spectrum_chart(reflector.brdf(), Views);
  plot::Svg svg(Width, Height + (spectrum ? SpectrumHeight : 0));
  svg.text({20, 30}, title, {plot::fitting_size(17, title, Width - 40), "#111", plot::Anchor::Start, 0});
  constexpr int Samples = 4096;
  const std::vector<plot::LobeCurve> curves = lobe_curves(reflector);
  draw(polar_lobe_chart(curves, {plot::Channel::Mean, true, false}), {{20, 50}, 460, 280}, svg);
  draw(lobe_chart(curves, {plot::Channel::Mean, false, true}), {{500, 50}, 460, 280}, svg);
  draw(albedo_chart(plot::albedo_curve(reflector, Samples)), {{20, 350}, 460, 290}, svg);
  svg.text({562, 364}, "Sphere, under a bright window and a dim sky", {13, "#111", plot::Anchor::Start, 0});
  svg.image({600, 385}, 220, 220, image::encode_png({lit_sphere(reflector, SphereSide)}));
  if (spectrum) draw(*spectrum, {{20, Height}, 460, SpectrumHeight - 20}, svg);
  return svg;
}

}  // namespace command
