#include "converters/renderers/pbrt_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "converters/renderers/surroundings_image.h"
#include "converters/renderers/words.h"
#include "grf/text_file.h"

namespace convert {
namespace {

using Base = WrittenMaterial::Base;

/// A wavelength below and one above all that pbrt renders, in nanometres: spectra are 0 beyond their ends.
constexpr int FirstWavelength = 300;
constexpr int LastWavelength = 900;

std::string pbrt_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

/// Returns pbrt's angle, of the shorter side of the image, in degrees.
double shorter_field_of_view(const RenderView& view) {
  if (view.width >= view.height) return view.field_of_view;
  const double tangent = std::tan(view.field_of_view * std::numbers::pi / 360);
  return 360 / std::numbers::pi * std::atan(tangent * view.width / view.height);
}

/// Composes the text, a statement at a time.
class PbrtWriter {
 public:
  explicit PbrtWriter(const WrittenScene& scene) : scene_(scene) {}

  std::string text() {
    put("# A scene for pbrt-v4, written by Granada's grfconvert.\n");
    put_options();
    put_camera();
    put("\nWorldBegin\n");
    put_surroundings();
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) put_material(i);
    for (const WrittenShape& shape : scene_.shapes) put_shape(shape);
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) put_object(i);
    for (const RenderInstance& instance : scene_.instances) put_instance(instance);
    return std::move(text_);
  }

 private:
  template <class... Arguments>
  void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }

  void put_options();
  void put_camera();
  void put_surroundings();
  void put_material(std::size_t index);
  void put_base(const std::string& name, const WrittenMaterial& material);
  void put_mirror(const std::string& name, const grf::Colour& reflectance);
  void put_image(const std::string& name, const std::string& file, std::string_view filter,
                 std::string_view type = "spectrum");
  void put_shape(const WrittenShape& shape);
  void put_object(std::size_t index);
  void put_instance(const RenderInstance& instance);

  const WrittenScene& scene_;
  std::string text_;
  std::size_t images_ = 0;
  std::size_t opacity_images_ = 0;
};

// pbrt saves halves by default, of 11 bits and up to 65504: less than a bright lamp.
void PbrtWriter::put_options() {
  const RenderView& view = scene_.view;
  const std::string stem = grf::file_name(scene_.path);
  put("Film \"rgb\" \"string filename\" [ {} ]\n", pbrt_string(stem.substr(0, stem.rfind('.')) + ".exr"));
  put("  \"integer xresolution\" [ {} ] \"integer yresolution\" [ {} ]\n", view.width, view.height);
  put("  \"string sensor\" [ \"cie1931\" ] \"float iso\" [ 100 ] \"bool savefp16\" [ false ]\n");
  put("PixelFilter \"box\" \"float xradius\" [ 0.5 ] \"float yradius\" [ 0.5 ]\n");
  put("Sampler \"halton\" \"integer pixelsamples\" [ {} ]\n", view.samples);
  put("Integrator \"path\" \"integer maxdepth\" [ {} ]\n", view.depth);
}

// The point looked at is as far away as the eye is from the origin, so that a float keeps the direction.
void PbrtWriter::put_camera() {
  const RenderView& view = scene_.view;
  const grf::Vec3d target = view.eye + view.forward * std::max(1.0, view.eye.length());
  put("\n# Coordinates of pbrt are left-handed: without the mirroring, left and right are swapped.\n");
  put("Scale -1 1 1\n");
  put("LookAt {}  {}  {}\n", words(view.eye), words(target), words(view.up));
  put("Camera \"perspective\" \"float fov\" [ {} ]", shorter_field_of_view(view));
  if (view.lens_radius > 0)
    put("\n  \"float lensradius\" [ {} ] \"float focaldistance\" [ {} ]", view.lens_radius,
        view.focus_distance);
  put("\n");
}

void PbrtWriter::put_surroundings() {
  if (!scene_.surroundings.empty()) {
    put("LightSource \"infinite\" \"string filename\" [ {} ] \"float scale\" [ {} ]\n",
        pbrt_string(scene_.surroundings), scene_.view.surroundings->scale);
  } else if (scene_.view.background != grf::Colour(0)) {
    put("LightSource \"infinite\" \"rgb L\" [ {} ]\n", words(scene_.view.background));
  }
}

void PbrtWriter::put_image(const std::string& name, const std::string& file, std::string_view filter,
                           std::string_view type) {
  put("Texture {} \"{}\" \"imagemap\" \"string filename\" [ {} ] \"string filter\" [ \"{}\" ]\n",
      pbrt_string(name), type, pbrt_string(file), filter);
}

void PbrtWriter::put_base(const std::string& name, const WrittenMaterial& material) {
  const std::string image = name + " image";
  if (!material.image.empty()) put_image(image, material.image, "trilinear");
  put("MakeNamedMaterial {} \"string type\" ", pbrt_string(name));
  switch (material.base) {
    case Base::Measured:
      return put("[ \"measured\" ] \"string filename\" [ {} ]\n", pbrt_string(material.table));
    case Base::Conductor:
      return put(
          "[ \"conductor\" ]\n  \"spectrum eta\" [ {0} {2} {1} {2} ] \"spectrum k\" [ {0} {3} {1} {3} ]\n"
          "  \"float roughness\" [ {4} ] \"bool remaproughness\" [ false ]\n",
          FirstWavelength, LastWavelength, material.facets.real_index, material.facets.imaginary_index,
          material.facets.alpha);
    case Base::Glass:
      return put("[ \"{}\" ] \"float eta\" [ {} ]\n", material.is_pane ? "thindielectric" : "dielectric",
                 material.index);
    case Base::Diffuse:
      if (!material.image.empty())
        return put("[ \"diffuse\" ] \"texture reflectance\" [ {} ]\n", pbrt_string(image));
      return put("[ \"diffuse\" ] \"rgb reflectance\" [ {} ]\n", words(material.reflectance));
    case Base::Black:
      return put("[ \"diffuse\" ] \"rgb reflectance\" [ 0 0 0 ]\n");
  }
}

void PbrtWriter::put_mirror(const std::string& name, const grf::Colour& reflectance) {
  put("MakeNamedMaterial {} \"string type\" [ \"conductor\" ] \"rgb reflectance\" [ {} ]\n",
      pbrt_string(name), words(reflectance));
  put("  \"float roughness\" [ 0 ]\n");
}

void PbrtWriter::put_material(std::size_t index) {
  const WrittenMaterial& material = scene_.materials[index];
  const std::string name = fmt::format("material {}", index + 1);
  if (material.mirror_share <= 0) return put_base(name, material);
  if (material.mirror_share >= 1) return put_mirror(name, material.mirror);
  put_base(name + " base", material);
  put_mirror(name + " mirror", material.mirror);
  put("MakeNamedMaterial {} \"string type\" [ \"mix\" ] \"string materials\" [ {} {} ]\n", pbrt_string(name),
      pbrt_string(name + " base"), pbrt_string(name + " mirror"));
  put("  \"float amount\" [ {} ]\n", material.mirror_share);
}

void PbrtWriter::put_shape(const WrittenShape& shape) {
  const std::string image = fmt::format("colours {}", images_ + 1);
  put("AttributeBegin\n");
  if (shape.image.empty()) {
    put("  NamedMaterial \"material {}\"\n", shape.material + 1);
  } else {
    ++images_;
    put_image(image, shape.image, "bilinear");
    put("  Material \"diffuse\" \"texture reflectance\" [ {} ]\n", pbrt_string(image));
  }
  if (shape.emission) put("  AreaLightSource \"diffuse\" \"rgb L\" [ {} ]\n", words(*shape.emission));
  const std::string opacity = fmt::format("opacity {}", opacity_images_ + 1);
  if (!shape.opacity_image.empty()) {
    ++opacity_images_;
    put_image(opacity, shape.opacity_image, "bilinear", "float");
  }
  put("  Shape \"plymesh\" \"string filename\" [ {} ]", pbrt_string(shape.mesh));
  if (!shape.opacity_image.empty()) {
    put(" \"texture alpha\" [ {} ]", pbrt_string(opacity));
  } else if (shape.opacity < 1) {
    put(" \"float alpha\" [ {} ]", shape.opacity);
  }
  put("\nAttributeEnd\n");
}

void PbrtWriter::put_object(std::size_t index) {
  put("ObjectBegin \"object {}\"\n", index + 1);
  for (const WrittenShape& shape : scene_.objects[index]) put_shape(shape);
  put("ObjectEnd\n");
}

// The columns of pbrt's matrix follow each other, as the rows of ours do, which are for row vectors.
void PbrtWriter::put_instance(const RenderInstance& instance) {
  put("AttributeBegin\n  Transform [");
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) put(" {}", instance.to_world[row][column]);
  }
  put(" ]\n  ObjectInstance \"object {}\"\nAttributeEnd\n", instance.object + 1);
}

}  // namespace

RenderTarget pbrt_target() {
  RenderTarget target;
  target.suffix = "pbrt";
  target.material.colours = reflectance::RglColours::Spectra;
  target.material.has_ggx_conductor = true;
  target.masks_emission = true;
  target.surroundings = equal_area_image;
  return target;
}

std::string pbrt_text(const WrittenScene& scene) { return PbrtWriter(scene).text(); }

}  // namespace convert
