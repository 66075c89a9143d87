#include "python/brdf.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>

#include "grf/write.h"
#include "python/messages.h"
#include "python/module.h"
#include "renderer/reflectance/albedo.h"
#include "renderer/reflectance/scheme.h"
#include "renderer/studies/angles.h"

namespace python {
namespace {

using reflectance::Rgb;
using reflectance::Vec3f;

constexpr const char* NotUnit = "is not a unit vector";

// A number just below 1 in double may be 1 in float.
bool is_uniform(float number) { return number >= 0 && number <= 1; }
float below_one(float number) { return std::min(number, 0x1.fffffep-1F); }

Rgb* rgb_data(py::array_t<float>& array) { return reinterpret_cast<Rgb*>(array.mutable_data()); }

/// Evaluates a function of two directions for all pairs; `Value` is Rgb or float.
template <class Value, class Function>
py::object for_pairs(const py::object& wi, const py::object& wo, const Function& function) {
  const py::array lights = vectors_of(wi, 3, "wi");
  const py::array views = vectors_of(wo, 3, "wo");
  const Shape shape = common_shape({lights, views});
  py::array_t<float> result(std::is_same_v<Value, Rgb> ? with_axis(shape, 3) : shape);
  auto* values = reinterpret_cast<Value*>(result.mutable_data());
  const RowReader light(lights, shape);
  const RowReader view(views, shape);
  FirstWrongRow wrong_light;
  FirstWrongRow wrong_view;
  for_each_block(size_of(shape), [&](std::size_t first, std::size_t count) {
    Block lights_read;
    Block views_read;
    const std::span v(lights_read.data(), count);
    const std::span u(views_read.data(), count);
    light.read(first, v);
    view.read(first, u);
    wrong_light.check_units(v, first);
    wrong_view.check_units(u, first);
    for (std::size_t i = 0; i < count; ++i) values[first + i] = function(u[i], v[i]);
  });
  wrong_light.raise("wi", NotUnit);
  wrong_view.raise("wo", NotUnit);
  return result_of(result);
}

/// The arrays of samples while they are written.
struct SampleArrays {
  explicit SampleArrays(const Shape& shape)
      : directions(with_axis(shape, 3)),
        weights(with_axis(shape, 3)),
        pdfs(shape),
        are_specular(shape),
        are_valid(shape) {}

  Samples result() const {
    return {directions, weights, result_of(pdfs), result_of(are_specular), result_of(are_valid)};
  }

  py::array_t<float> directions, weights, pdfs;
  py::array_t<bool> are_specular, are_valid;
};

constexpr const char* BrdfText =
    R"(A BRDF with a sampling scheme: BRDF('ward sx=0.1 sy=0.3'), BRDF('gold.binary', scheme='adaptive').

text is what `bpt brdf` takes: a model with its parameters as in a scene, the name of a file with such a text
or of measured data (MERL .binary, RGL .bsdf), or 'scene.grf:NAME' for a definition of a scene. scheme is a
sampling scheme as after the keyword pdf: 'own' (the model's own sampler), 'auto', 'hemisphere exp=20'.
Raises granada.Error if either is wrong, or if the scheme cannot sample the BRDF.

Directions are unit vectors in the local frame, whose z axis is the normal: wi points towards the light, wo
towards the eye. Arrays of shape (..., 3) are broadcast like NumPy's; values are float32, computed without
Python's global lock and on all cores.)";

constexpr const char* EvaluateText =
    R"(Return the value f of the BRDF in 1/sr, RGB, of shape (..., 3).

The cosine is not in it, nor is the specular (delta) part. It is 0 if a direction is at or below the horizon.)";

constexpr const char* PdfText =
    R"(Return the pdf of `sample` for wi at the view wo, per solid angle in 1/sr.

It is that of directions that are not the specular (delta) part's.)";

constexpr const char* SampleText =
    R"(Draw a direction wi for each view wo, by three independent uniform numbers in [0, 1) of u.

Returns Samples. The mean of their `weight`, which is f cos(theta_i) / pdf, is the albedo.)";

constexpr const char* AlbedoText =
    R"(Return the directional albedo, RGB, of shape (..., 3): the integral of f cos(theta_i), with the specular
(delta) part.

theta is the angle of the view from the normal and phi that from the x axis, in radians. It is computed by
quasi-Monte Carlo with so many samples; by default it is within 0.002.)";

constexpr const char* SpecularText =
    R"(Return the weight of the specular (delta) part, RGB, of shape (..., 3).

It is the fraction of light that is reflected into the mirror direction of wo, 0 for models without such a
part.)";

void define_samples(py::module_& module) {
  py::class_<Samples>(module, "Samples", "Directions that BRDF.sample drew, an element each.")
      .def_readonly("wi", &Samples::wi, "Directions towards the light, (..., 3); (0, 0, 0) where not valid.")
      .def_readonly(
          "weight", &Samples::weight,
          "f cos(theta_i) / pdf, RGB, (..., 3); 0 where not valid. For the specular (delta) part, its "
          "weight over its probability.")
      .def_readonly("pdf", &Samples::pdf, "Solid-angle pdf in 1/sr, (...); 0 for the specular (delta) part.")
      .def_readonly("is_specular", &Samples::is_specular, "Whether it is the specular (delta) part's, (...).")
      .def_readonly("is_valid", &Samples::is_valid,
                    "False for rejected samples, which contribute nothing to a mean, (...).")
      .def("__repr__", [](const Samples& samples) {
        return py::str("<granada.Samples of shape {}>")
            .format(py::module_::import("numpy").attr("shape")(samples.pdf));
      });
}

py::dict models() {
  py::dict all;
  for (const grf::ModelInfo& model : reflectance::brdf_infos()) {
    py::dict parameters;
    for (const grf::ParameterInfo& parameter : model.parameters) {
      py::dict facts;
      facts["minimum"] = grf::shortest(parameter.minimum);
      facts["maximum"] = grf::shortest(parameter.maximum);
      facts["default"] = grf::shortest(parameter.default_value);
      facts["unit"] = parameter.unit;
      facts["help"] = parameter.help;
      parameters[py::str(std::string(parameter.name))] = facts;
    }
    py::dict facts;
    facts["title"] = model.title;
    facts["paper"] = model.paper;
    facts["example"] = model.example;
    facts["isotropic"] = model.not_isotropic.empty();
    facts["reciprocal"] = model.not_reciprocal.empty();
    facts["conserves_energy"] = model.not_conserving.empty();
    facts["parameters"] = parameters;
    all[py::str(std::string(model.keyword))] = facts;
  }
  return all;
}

}  // namespace

reflectance::SampledInstance Brdf::read(const std::string& text, const std::string& scheme) {
  grf::Diagnostics diagnostics;
  std::optional<reflectance::SampledInstance> instance;
  {
    const py::gil_scoped_release released;
    instance = reflectance::read_sampled_instance(text, scheme, diagnostics);
  }
  if (!instance) raise_error(diagnostics);
  return *std::move(instance);
}

Brdf::Brdf(const std::string& text, const std::string& scheme)
    : scheme_(scheme), instance_(read(text, scheme)) {}

std::string Brdf::text() const { return grf::to_text(instance_.model); }

py::object Brdf::evaluate(const py::object& wi, const py::object& wo) const {
  return for_pairs<Rgb>(
      wi, wo, [this](const Vec3f& u, const Vec3f& v) { return instance_.reflector.evaluate(u, v); });
}

py::object Brdf::pdf(const py::object& wi, const py::object& wo) const {
  return for_pairs<float>(wi, wo,
                          [this](const Vec3f& u, const Vec3f& v) { return instance_.reflector.pdf(u, v); });
}

py::object Brdf::specular_weight(const py::object& wo) const {
  return for_pairs<Rgb>(wo, wo, [this](const Vec3f& u, const Vec3f&) {
    return u.z > 0 ? reflectance::specular_weight(instance_.reflector.brdf(), u) : Rgb(0);
  });
}

Samples Brdf::sample(const py::object& wo, const py::object& numbers) const {
  const py::array views = vectors_of(wo, 3, "wo");
  const py::array uniforms = vectors_of(numbers, 3, "u");
  const Shape shape = common_shape({views, uniforms});
  SampleArrays arrays(shape);
  Rgb* directions = rgb_data(arrays.directions);
  Rgb* weights = rgb_data(arrays.weights);
  float* pdfs = arrays.pdfs.mutable_data();
  bool* are_specular = arrays.are_specular.mutable_data();
  bool* are_valid = arrays.are_valid.mutable_data();
  const RowReader view(views, shape);
  const RowReader uniform(uniforms, shape);
  FirstWrongRow wrong_view;
  FirstWrongRow wrong_number;
  const auto draw = [&](std::size_t i, const Vec3f& u, const Vec3f& xi) {
    wrong_number.check(is_uniform(xi.x) && is_uniform(xi.y) && is_uniform(xi.z), i);
    const auto drawn =
        u.z > 0 ? instance_.reflector.sample(u, {{below_one(xi.x), below_one(xi.y)}, below_one(xi.z)})
                : std::nullopt;
    directions[i] = drawn ? drawn->direction : Vec3f(0);
    weights[i] = drawn ? drawn->weight : Rgb(0);
    pdfs[i] = drawn ? drawn->pdf : 0;
    are_specular[i] = drawn && drawn->is_specular;
    are_valid[i] = drawn.has_value();
  };
  for_each_block(size_of(shape), [&](std::size_t first, std::size_t count) {
    Block views_read;
    Block uniforms_read;
    const std::span u(views_read.data(), count);
    const std::span xi(uniforms_read.data(), count);
    view.read(first, u);
    uniform.read(first, xi);
    wrong_view.check_units(u, first);
    for (std::size_t i = 0; i < count; ++i) draw(first + i, u[i], xi[i]);
  });
  wrong_view.raise("wo", NotUnit);
  wrong_number.raise("u", "is not in [0, 1)");
  return arrays.result();
}

py::object Brdf::albedo(const py::object& theta, const py::object& phi, int samples) const {
  if (samples < 1) throw py::value_error("albedo needs one sample or more");
  const py::array thetas = numbers_of(theta);
  const py::array phis = numbers_of(phi);
  const Shape shape = common_shape({thetas, phis});
  py::array_t<float> result(with_axis(shape, 3));
  Rgb* values = rgb_data(result);
  const RowReader polar(thetas, shape);
  const RowReader azimuth(phis, shape);
  FirstWrongRow wrong;
  for_each_range(size_of(shape), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const studies::Angles angles = {polar.number(i), azimuth.number(i)};
      const Vec3f u = studies::direction_of(angles);
      wrong.check(std::isfinite(angles.theta) && std::isfinite(angles.phi), i);
      values[i] = u.z > 0 ? reflectance::albedo(instance_.reflector, u, samples) : Rgb(0);
    }
  });
  wrong.raise("theta", "or phi is not a finite number");
  return result_of(result);
}

void define_brdfs(py::module_& module) {
  define_samples(module);
  py::class_<Brdf>(module, "BRDF", BrdfText)
      .def(py::init<const std::string&, const std::string&>(), py::arg("text"), py::arg("scheme") = "own")
      .def("eval", &Brdf::evaluate, py::arg("wi"), py::arg("wo"), EvaluateText)
      .def("pdf", &Brdf::pdf, py::arg("wi"), py::arg("wo"), PdfText)
      .def("sample", &Brdf::sample, py::arg("wo"), py::arg("u"), SampleText)
      .def("specular_weight", &Brdf::specular_weight, py::arg("wo"), SpecularText)
      .def("albedo", &Brdf::albedo, py::arg("theta"), py::arg("phi") = 0.0, py::arg("samples") = 16384,
           AlbedoText)
      .def_property_readonly("text", &Brdf::text, "The BRDF as text of a scene.")
      .def_property_readonly("keyword", &Brdf::keyword, "The keyword of the model, such as 'ward'.")
      .def_property_readonly("scheme", &Brdf::scheme, "The sampling scheme, as it was given.")
      .def("__repr__", [](const Brdf& brdf) {
        return py::str("granada.BRDF({!r}, scheme={!r})").format(brdf.text(), brdf.scheme());
      });
  module.def("models", &models,
             "Return the BRDF models by keyword, each a dict with its title, paper, example and parameters.");
}

}  // namespace python
