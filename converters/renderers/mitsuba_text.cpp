#include "converters/renderers/mitsuba_text.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "converters/renderers/surroundings_image.h"
#include "converters/renderers/words.h"
#include "converters/text_encoding.h"

namespace convert {
namespace {

using Base = WrittenMaterial::Base;

/// Composes the text, an element at a time.
class MitsubaWriter {
 public:
  explicit MitsubaWriter(const WrittenScene& scene) : scene_(scene) {}

  std::string text() {
    put("<!-- A scene for Mitsuba 3, written by Granada's grfconvert. Tables are for RGB variants. -->");
    begin("scene version=\"3.0.0\"");
    put_integrator();
    put_sensor();
    put_surroundings();
    for (std::size_t i = 0; i < scene_.materials.size(); ++i) put_material(i);
    for (const WrittenShape& shape : scene_.shapes) put_shape(shape);
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) put_object(i);
    for (const RenderInstance& instance : scene_.instances) put_instance(instance);
    end();
    return std::move(text_);
  }

 private:
  void put(std::string_view line) { text_ += std::string(2 * open_.size(), ' ') + std::string(line) + "\n"; }
  void begin(const std::string& element) {
    put("<" + element + ">");
    open_.push_back(element.substr(0, element.find(' ')));
  }
  void end() {
    const std::string element = open_.back();
    open_.pop_back();
    put("</" + element + ">");
  }
  /// Puts a plugin with its parameters inside.
  template <class Inside>
  void plugin(std::string_view element, std::string_view type, std::string_view more, const Inside& inside) {
    begin(fmt::format("{} type=\"{}\"{}", element, type, more));
    inside();
    end();
  }
  void parameter(std::string_view type, std::string_view name, const std::string& value) {
    put(fmt::format("<{} name=\"{}\" value=\"{}\"/>", type, name, xml_value(value)));
  }
  void number(std::string_view name, double value) { parameter("float", name, fmt::format("{}", value)); }
  void colour(std::string_view name, const grf::Colour& value) { parameter("rgb", name, words(value)); }

  void put_integrator();
  void put_sensor();
  void put_film();
  void put_surroundings();
  void put_material(std::size_t index);
  void put_base(const WrittenMaterial& material);
  void put_diffuse(const WrittenMaterial& material);
  void put_mirror(const grf::Colour& reflectance);
  void put_material_of(const WrittenShape& shape);
  void put_shape(const WrittenShape& shape);
  void put_object(std::size_t index);
  void put_instance(const RenderInstance& instance);

  const WrittenScene& scene_;
  std::string text_;
  std::vector<std::string> open_;
};

// Mitsuba counts the segments of a path.
void MitsubaWriter::put_integrator() {
  plugin("integrator", "path", "",
         [&] { parameter("integer", "max_depth", std::to_string(scene_.view.depth + 1)); });
}

void MitsubaWriter::put_film() {
  const RenderView& view = scene_.view;
  plugin("sampler", "independent", "",
         [&] { parameter("integer", "sample_count", std::to_string(view.samples)); });
  plugin("film", "hdrfilm", "", [&] {
    parameter("integer", "width", std::to_string(view.width));
    parameter("integer", "height", std::to_string(view.height));
    parameter("string", "pixel_format", "rgb");
    parameter("string", "component_format", "float32");
    plugin("rfilter", "box", "", [] {});
  });
}

// Clipping planes, which Mitsuba has by default, depend on the size of the scene.
void MitsubaWriter::put_sensor() {
  const RenderView& view = scene_.view;
  const bool has_lens = view.lens_radius > 0;
  plugin("sensor", has_lens ? "thinlens" : "perspective", "", [&] {
    begin("transform name=\"to_world\"");
    const grf::Vec3d target = view.eye + view.forward * std::max(1.0, view.eye.length());
    const auto comma = [](const grf::Vec3d& v) { return fmt::format("{}, {}, {}", v.x, v.y, v.z); };
    put(fmt::format("<lookat origin=\"{}\" target=\"{}\" up=\"{}\"/>", comma(view.eye), comma(target),
                    comma(view.up)));
    end();
    number("fov", view.field_of_view);
    parameter("string", "fov_axis", "y");
    number("near_clip", 1e-5 * scene_.reach);
    number("far_clip", 10 * scene_.reach);
    if (has_lens) {
      number("aperture_radius", view.lens_radius);
      number("focus_distance", view.focus_distance);
    }
    put_film();
  });
}

void MitsubaWriter::put_surroundings() {
  if (!scene_.surroundings.empty()) {
    plugin("emitter", "envmap", "", [&] {
      parameter("string", "filename", scene_.surroundings);
      number("scale", double(scene_.view.surroundings->scale));
    });
  } else if (scene_.view.background != grf::Colour(0)) {
    plugin("emitter", "constant", "", [&] { colour("radiance", scene_.view.background); });
  }
}

void MitsubaWriter::put_diffuse(const WrittenMaterial& material) {
  plugin("bsdf", "diffuse", "", [&] {
    if (!material.image.empty()) {
      plugin("texture", "bitmap", " name=\"reflectance\"",
             [&] { parameter("string", "filename", material.image); });
    } else if (material.has_vertex_colours) {
      plugin("texture", "mesh_attribute", " name=\"reflectance\"",
             [&] { parameter("string", "name", "vertex_color"); });
    } else {
      colour("reflectance", material.reflectance);
    }
  });
}

void MitsubaWriter::put_base(const WrittenMaterial& material) {
  if (material.base != Base::Measured) return put_diffuse(material);
  plugin("bsdf", "measured", "", [&] { parameter("string", "filename", material.table); });
}

void MitsubaWriter::put_mirror(const grf::Colour& reflectance) {
  plugin("bsdf", "conductor", "", [&] {
    parameter("string", "material", "none");
    colour("specular_reflectance", reflectance);
  });
}

// Reflectance of GRF is that of both sides, and BSDFs of Mitsuba are black from behind.
void MitsubaWriter::put_material(std::size_t index) {
  const WrittenMaterial& material = scene_.materials[index];
  const std::string id = fmt::format(" id=\"material_{}\"", index + 1);
  if (material.base == Base::Glass) {
    return plugin("bsdf", material.is_pane ? "thindielectric" : "dielectric", id, [&] {
      number("int_ior", material.index);
      number("ext_ior", 1);
      if (material.is_pane) colour("specular_transmittance", material.pane_colour);
    });
  }
  plugin("bsdf", "twosided", id, [&] {
    if (material.mirror_share <= 0) return put_base(material);
    const auto share = static_cast<float>(material.mirror_share);
    if (material.base == Base::Black) return put_mirror(share * material.mirror);
    plugin("bsdf", "blendbsdf", "", [&] {
      number("weight", material.mirror_share);
      put_base(material);
      put_mirror(material.mirror);
    });
  });
}

void MitsubaWriter::put_material_of(const WrittenShape& shape) {
  const std::string reference = fmt::format("<ref id=\"material_{}\"/>", shape.material + 1);
  if (shape.opacity_image.empty() && shape.opacity >= 1) return put(reference);
  plugin("bsdf", "mask", "", [&] {
    if (shape.opacity_image.empty()) {
      number("opacity", shape.opacity);
    } else {
      plugin("texture", "bitmap", " name=\"opacity\"", [&] {
        parameter("string", "filename", shape.opacity_image);
        parameter("boolean", "raw", "true");
      });
    }
    put(reference);
  });
}

// Without normals of vertices, Mitsuba would compute some.
void MitsubaWriter::put_shape(const WrittenShape& shape) {
  plugin("shape", "ply", "", [&] {
    parameter("string", "filename", shape.mesh);
    if (!shape.has_normals) parameter("boolean", "face_normals", "true");
    if (shape.has_uvs) parameter("boolean", "flip_tex_coords", "true");
    put_material_of(shape);
    if (shape.emission) plugin("emitter", "area", "", [&] { colour("radiance", *shape.emission); });
  });
}

void MitsubaWriter::put_object(std::size_t index) {
  plugin("shape", "shapegroup", fmt::format(" id=\"object_{}\"", index + 1), [&] {
    for (const WrittenShape& shape : scene_.objects[index]) put_shape(shape);
  });
}

// Mitsuba's matrices are for column vectors, and are written row by row.
void MitsubaWriter::put_instance(const RenderInstance& instance) {
  plugin("shape", "instance", "", [&] {
    begin("transform name=\"to_world\"");
    std::string matrix;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        fmt::format_to(std::back_inserter(matrix), "{}{}", matrix.empty() ? "" : " ",
                       instance.to_world[column][row]);
      }
    }
    put(fmt::format("<matrix value=\"{}\"/>", matrix));
    end();
    put(fmt::format("<ref id=\"object_{}\"/>", instance.object + 1));
  });
}

}  // namespace

RenderTarget mitsuba_target() {
  RenderTarget target;
  target.suffix = "mitsuba";
  target.material.colours = reflectance::RglColours::LinearSrgb;
  target.material.has_pane_colour = true;
  target.has_mesh_attributes = true;
  target.surroundings = mitsuba_latitude_longitude;
  return target;
}

std::string mitsuba_text(const WrittenScene& scene) { return MitsubaWriter(scene).text(); }

}  // namespace convert
