#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "grf/catalogue.h"
#include "renderer/reflectance/ashikhmin.h"
#include "renderer/reflectance/beardmaxwell.h"
#include "renderer/reflectance/blinn.h"
#include "renderer/reflectance/combine.h"
#include "renderer/reflectance/coupled.h"
#include "renderer/reflectance/diffuse.h"
#include "renderer/reflectance/eon.h"
#include "renderer/reflectance/ggx.h"
#include "renderer/reflectance/glass.h"
#include "renderer/reflectance/gltf.h"
#include "renderer/reflectance/granier.h"
#include "renderer/reflectance/hanrahan.h"
#include "renderer/reflectance/he.h"
#include "renderer/reflectance/kajiya.h"
#include "renderer/reflectance/lafortune.h"
#include "renderer/reflectance/lewis.h"
#include "renderer/reflectance/measured.h"
#include "renderer/reflectance/minnaert.h"
#include "renderer/reflectance/neumann.h"
#include "renderer/reflectance/openpbr.h"
#include "renderer/reflectance/oren.h"
#include "renderer/reflectance/phong.h"
#include "renderer/reflectance/poulin.h"
#include "renderer/reflectance/rgl.h"
#include "renderer/reflectance/schlick.h"
#include "renderer/reflectance/sheen.h"
#include "renderer/reflectance/specular.h"
#include "renderer/reflectance/strauss.h"
#include "renderer/reflectance/thinfilm.h"
#include "renderer/reflectance/torrance.h"
#include "renderer/reflectance/transmission.h"
#include "renderer/reflectance/ward.h"
#include "renderer/reflectance/westin.h"

namespace reflectance {

/// The analytic models: the only list that a new model is added to.
using FormulaBrdf =
    std::variant<Specular, Diffuse, Phong, Blinn, Lewis, Ward, Minnaert, Lafortune, Oren, Torrance, Coupled,
                 Ashikhmin, Schlick, Strauss, Neumann, BeardMaxwell, Kajiya, Hanrahan, Westin, Granier,
                 Poulin, He, Eon, Ggx, Sheen, ThinFilm, Gltf, OpenPbr, Glass>;

template <class Variant, class... More>
struct Extended;
template <class... Types, class... More>
struct Extended<std::variant<Types...>, More...> {
  using Type = std::variant<Types..., More...>;
};

/// All BRDFs: the analytic models, measured data and weighted sums.
using AnyBrdf = Extended<FormulaBrdf, Measured, Rgl, Combine>::Type;

/// A BRDF of any model. It is a class so that copying, which takes long to compile for so many types, is
/// compiled once.
class Brdf : public AnyBrdf {
 public:
  using AnyBrdf::AnyBrdf;
  Brdf();
  ~Brdf();
  Brdf(const Brdf& other);
  Brdf(Brdf&& other) noexcept;
  Brdf& operator=(const Brdf& other);
  Brdf& operator=(Brdf&& other) noexcept;
};

/// One term of a weighted sum, which may be below layers.
struct CombinedBrdf {
  float weight = 0;
  Brdf brdf;
  std::shared_ptr<const Transmission> transmission = nullptr;  ///< of the layers above; null: there are none

  float albedo_estimate(const Vec3f& u) const;

  /// Scales a value of the BRDF for these directions by its weight and by what the layers above transmit.
  template <class Real>
  Vec3<Real> contribution(const Vec3<Real>& value, const Vec3<Real>& u, const Vec3<Real>& v) const {
    const Vec3<Real> weighted = value * Real(weight);
    return transmission ? weighted * transmission->factor(u, v) : weighted;
  }
  /// Returns the weight of the delta part in the sum. Its directions are at the same angle from the normal.
  Rgb specular_weight(const Vec3f& u) const;
};
struct CombinedBrdfs : std::vector<CombinedBrdf> {};

/// Makes the BRDF that a scene's model describes, or returns nothing if no BRDF has its keyword. Values must
/// have been checked against the catalogue. BrdfMaker also loads measured data and resolves sums and layers:
/// a `coat` is that over black here.
std::optional<Brdf> make_brdf(const grf::Model& data);

/// Returns the BRDF of a face that has none: diffuse with kd = 0.5.
Brdf default_brdf();
/// Returns the default BRDF as a scene's model.
grf::BrdfModel default_model();

/// Evaluates f(u, v) in 1/sr, without the delta part.
Rgb evaluate(const Brdf& brdf, const Vec3f& u, const Vec3f& v);

/// Returns the weight of a model's delta part, 0 if it has none.
template <class Model>
Rgb specular_weight_of(const Model& model, const Vec3f& u) {
  if constexpr (requires { model.specular_weight(u); }) {
    return model.specular_weight(u);
  } else {
    return Rgb(0);
  }
}
/// Returns the weight of a BRDF's delta part, 0 if it has none.
Rgb specular_weight(const Brdf& brdf, const Vec3f& u);

/// Draws a direction with the model's own closed-form sampler, with its pdf.
std::optional<DirectionSample> own_sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi);
float own_pdf(const Brdf& brdf, const Vec3f& u, const Vec3f& v);

// The queries below tell the lobes that a BRDF has with its parameters. A model may have a member of the same
// name; else the answer is inferred, so that a lobe is rather assumed than missed.

/// Returns true if there is a delta part. Inferred from `specular_weight`.
bool has_specular_part(const Brdf& brdf);

/// Returns true if there is anything besides a delta part.
bool has_nonspecular_part(const Brdf& brdf);

/// Returns true if there is a diffuse lobe, which suits cosine-weighted sampling. Inferred from `kd`.
bool has_diffuse_part(const Brdf& brdf);

/// Returns true if there is a glossy lobe, neither diffuse nor delta. Inferred from `ks`; true without it.
bool has_glossy_part(const Brdf& brdf);

/// Returns true if rotating both directions about the normal changes the value. Inferred from the table.
bool is_anisotropic(const Brdf& brdf);

/// Returns the exponents of a BRDF's cosine lobe, or nothing if it has none. Inferred from `ex` and `ey`, or
/// from `n` as a half-vector lobe. For a sum, those of its widest lobe.
std::optional<LobeExponents> lobe_exponents(const Brdf& brdf);

/// Returns the descriptions of all models, in the order of the documents.
std::vector<grf::ModelInfo> brdf_infos();

}  // namespace reflectance
