#include "tests/reflectance/brdf_cases.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>

#include "renderer/reflectance/brdf_maker.h"
#include "renderer/reflectance/layers.h"
#include "renderer/reflectance/measurements/utia.h"
#include "tests/reflectance/rgl_cases.h"

namespace test {
namespace {

std::string instance(const grf::ModelInfo& model, const std::string& only, bool maximum) {
  std::string text(model.keyword);
  for (const grf::ParameterInfo& parameter : model.parameters) {
    if (!only.empty() && parameter.name != only) continue;
    if (parameter.kind == grf::ParameterKind::Word) {
      text += fmt::format(" {}={}", parameter.name,
                          maximum ? parameter.choices.back() : parameter.choices.front());
    } else {
      text += fmt::format(" {}={}", parameter.name, maximum ? parameter.maximum : parameter.minimum);
    }
  }
  return text;
}

// Returns false for values that are each in range but invalid together.
bool is_right(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto model = grf::read_brdf(text, "test", diagnostics);
  return model && grf::check(*model, reflectance::brdf_infos(), "BRDF", diagnostics);
}

Brdf simple_brdf(const std::string& text) {
  grf::Diagnostics diagnostics;
  const auto model = grf::read_brdf(text, "test", diagnostics);
  if (!model || !grf::check(*model, reflectance::brdf_infos(), "BRDF", diagnostics)) {
    throw std::runtime_error(diagnostics.to_text());
  }
  return *reflectance::make_brdf(*model);
}

/// Makes a coat from its parameters, which the format gives only together with a base.
reflectance::Coat coat_of(const std::string& parameters) {
  grf::Diagnostics diagnostics;
  auto model = grf::read_brdf("ggx" + parameters, "test", diagnostics);
  if (!model) throw std::runtime_error(diagnostics.to_text());
  return reflectance::make<reflectance::Coat>(*model);
}

Brdf layered_of(const std::string& top, const Brdf& base) {
  constexpr std::string_view Coat = "coat";
  if (top.starts_with(Coat)) return reflectance::layered(base, coat_of(top.substr(Coat.size())));
  return reflectance::layered(base, simple_brdf(top));
}

Brdf sum_of(const std::string& text) {
  auto parts = std::make_shared<reflectance::CombinedBrdfs>();
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(" + ", begin), text.size());
    const std::size_t space = text.find(' ', begin);
    parts->push_back(
        {std::stof(text.substr(begin, space - begin)), simple_brdf(text.substr(space, end - space))});
    begin = end + 3;
  }
  return reflectance::Combine{parts};
}

Brdf table_of(const std::string& text) {
  const Brdf brdf = simple_brdf(text);
  const auto table = std::make_shared<const reflectance::MerlTable>(
      [&](const Vec3f& u, const Vec3f& v) { return evaluate(brdf, u, v); });
  reflectance::Measured measured;
  measured.data = std::make_shared<const reflectance::MeasuredData>(table);
  return measured;
}

/// Returns a BRDF as it is read from a file of the UTIA data base, whose numbers are written in its order.
Brdf utia_of(const std::string& text) {
  const Brdf brdf = simple_brdf(text);
  std::string bytes;
  const auto direction_of = [](int index) {
    const auto theta = static_cast<float>(index / 48) * 15;
    return direction(theta, static_cast<float>(index % 48) * 7.5F);
  };
  for (int channel = 0; channel < 3; ++channel) {
    for (int light = 0; light < 288; ++light) {
      for (int view = 0; view < 288; ++view) {
        const double value(evaluate(brdf, direction_of(view), direction_of(light))[channel]);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
      }
    }
  }
  grf::Diagnostics diagnostics;
  reflectance::Measured measured;
  measured.data = std::make_shared<const reflectance::MeasuredData>(
      reflectance::parse_utia(bytes, "utia.bin", diagnostics));
  return measured;
}

Brdf measured_of(const std::string& name) {
  grf::Diagnostics diagnostics;
  reflectance::Measured measured;
  measured.data = reflectance::Measured::load(measured_path(name), diagnostics, {});
  if (!measured.data) throw std::runtime_error(diagnostics.to_text());
  return measured;
}

Brdf rgl_of(const std::string& name) {
  grf::Diagnostics diagnostics;
  reflectance::Rgl rgl;
  rgl.data = reflectance::RglData::load(rgl_path(name), diagnostics);
  if (!rgl.data) throw std::runtime_error(diagnostics.to_text());
  return rgl;
}

class PairGenerator {
 public:
  explicit PairGenerator(std::uint32_t seed) : random_(seed) {}

  Pair next() {
    const Vec3f u = any_direction();
    switch (random_() % 8) {
      case 0:
        return {u, u};
      case 1:
        return {u, reflectance::mirrored(u)};
      case 2:
        return {u, near(reflectance::mirrored(u))};
      case 3:
        return {u, near(u)};
      case 4:
        return {u, -u};
      default:
        return {u, any_direction()};
    }
  }

 private:
  float uniform() { return std::uniform_real_distribution<float>(0, 1)(random_); }

  // One in four is grazing, to within 1e-6 of the horizon; some are below it or in the planes of x and y.
  Vec3f any_direction() {
    float z = uniform();
    const unsigned kind = random_() % 16;
    if (kind < 4) z = std::pow(10.0F, -1 - 6 * uniform());
    if (kind == 4) z = -z;
    if (kind == 5) z = 1 - std::pow(10.0F, -1 - 6 * uniform());
    if (kind == 6) return along_an_axis(z);
    const float phi = 2 * reflectance::Pi * uniform();
    return reflectance::from_angles(z, std::sqrt((1 - z) * (1 + z)), phi);
  }

  Vec3f along_an_axis(float z) {
    const unsigned axis = random_() % 4;
    const float sine = (axis < 2 ? 1.0F : -1.0F) * std::sqrt((1 - z) * (1 + z));
    return axis % 2 == 0 ? Vec3f(sine, 0, z) : Vec3f(0, sine, z);
  }

  Vec3f near(const Vec3f& v) {
    const float distance = std::pow(10.0F, -6 + 5 * uniform());
    const Vec3f step{uniform() - 0.5F, uniform() - 0.5F,
                     uniform() - 0.5F};  // the order of the calls is fixed
    return (v + step * distance).normalized();
  }

  std::mt19937 random_;
};

}  // namespace

Brdf brdf_of(const std::string& text) {
  constexpr std::string_view Table = "table of ";
  if (text.starts_with(Table)) return table_of(text.substr(Table.size()));
  constexpr std::string_view Utia = "utia of ";
  if (text.starts_with(Utia)) return utia_of(text.substr(Utia.size()));
  constexpr std::string_view File = "measured ";
  if (text.starts_with(File)) return measured_of(text.substr(File.size()));
  constexpr std::string_view Over = " over ";
  if (const auto over = text.find(Over); over != std::string::npos) {
    return layered_of(text.substr(0, over), brdf_of(text.substr(over + Over.size())));
  }
  if (text.starts_with("coat")) return coat_of(text.substr(4)).facets();
  constexpr std::string_view Rgl = "rgl ";
  if (text.starts_with(Rgl)) return rgl_of(text.substr(Rgl.size()));
  return text.find(" + ") == std::string::npos ? simple_brdf(text) : sum_of(text);
}

std::optional<grf::Scene> scene_with(const std::string& definitions, const std::string& brdf,
                                     grf::Diagnostics& diagnostics, const std::string& last_end) {
  return grf::read_text(
      definitions + " begin begin mesh brdf " + brdf +
          " begin vertexs (0, 0, 0) (1, 0, 0) (0, 1, 0) end begin faces (0, 1, 2) end end " + last_end,
      "scene.grf", diagnostics);
}

std::optional<Brdf> brdf_in(const grf::Scene& scene, grf::Diagnostics& diagnostics) {
  std::optional<Brdf> brdf;
  grf::SceneVisitor visitor;
  visitor.mesh = [&](const grf::Mesh& mesh, const grf::Placement& placement, const grf::Block&) {
    const grf::ResolvedSurface surface = resolve(mesh.surface(0), placement.scope);
    brdf = reflectance::BrdfMaker(diagnostics).make(*surface.brdf, surface.brdf_scope);
  };
  visit(scene, visitor);
  return brdf;
}

std::vector<std::string> extreme_cases() {
  std::vector<std::string> cases;
  const auto add = [&](const std::string& text) {
    if (is_right(text)) cases.push_back(text);
  };
  for (const grf::ModelInfo& model : reflectance::brdf_infos()) {
    if (model.argument_kind != grf::ModelInfo::ArgumentKind::Parameters) continue;
    for (const bool maximum : {false, true}) {
      add(instance(model, "", maximum));
      for (const grf::ParameterInfo& parameter : model.parameters) {
        add(instance(model, std::string(parameter.name), maximum));
      }
    }
  }
  return cases;
}

std::vector<Pair> direction_pairs(int count, std::uint32_t seed) {
  PairGenerator generator(seed);
  std::vector<Pair> pairs;
  for (int i = 0; i < count; ++i) pairs.push_back(generator.next());
  return pairs;
}

}  // namespace test
