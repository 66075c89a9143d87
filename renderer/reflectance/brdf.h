#pragma once

#include <variant>
#include <vector>

#include "grf/catalogue.h"
#include "renderer/reflectance/ashikhmin.h"
#include "renderer/reflectance/beardmaxwell.h"
#include "renderer/reflectance/blinn.h"
#include "renderer/reflectance/combine.h"
#include "renderer/reflectance/coupled.h"
#include "renderer/reflectance/diffuse.h"
#include "renderer/reflectance/granier.h"
#include "renderer/reflectance/hanrahan.h"
#include "renderer/reflectance/he.h"
#include "renderer/reflectance/kajiya.h"
#include "renderer/reflectance/lafortune.h"
#include "renderer/reflectance/lewis.h"
#include "renderer/reflectance/measured.h"
#include "renderer/reflectance/minnaert.h"
#include "renderer/reflectance/neumann.h"
#include "renderer/reflectance/oren.h"
#include "renderer/reflectance/phong.h"
#include "renderer/reflectance/poulin.h"
#include "renderer/reflectance/schlick.h"
#include "renderer/reflectance/specular.h"
#include "renderer/reflectance/strauss.h"
#include "renderer/reflectance/torrance.h"
#include "renderer/reflectance/ward.h"
#include "renderer/reflectance/westin.h"

namespace reflectance {

/// The models that are a formula: the one list that a new model is added to.
using FormulaBrdf = std::variant<Specular, Diffuse, Phong, Blinn, Lewis, Ward, Minnaert, Lafortune, Oren,
                                 Torrance, Coupled, Ashikhmin, Schlick, Strauss, Neumann, BeardMaxwell,
                                 Kajiya, Hanrahan, Westin, Granier, Poulin, He>;

template <class Variant, class... More>
struct Extended;
template <class... Types, class... More>
struct Extended<std::variant<Types...>, More...> {
  using Type = std::variant<Types..., More...>;
};

/// All models: data and sums besides.
using AnyBrdf = Extended<FormulaBrdf, Measured, Combine>::Type;

/// One of them. It is a class so that copying, which takes long to compile for so many types, is compiled
/// once.
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

/// One term of a sum.
struct CombinedBrdf {
  float weight = 0;
  Brdf brdf;

  float albedo_estimate(const Vec3f& u) const;
};
struct CombinedBrdfs : std::vector<CombinedBrdf> {};

/// The BRDF that a model of the scene describes, or nothing if no BRDF has its keyword. Values are taken to
/// have been checked against the catalogue. What else a BRDF is made of, such as data, is BrdfMaker's
/// business.
std::optional<Brdf> make_brdf(const grf::Model& data);

/// What a face without a BRDF has: diffuse with kd = 0.5.
Brdf default_brdf();
/// The same as a scene writes it.
grf::BrdfModel default_model();

/// f(u, v) in 1/sr, without the Dirac part.
Rgb evaluate(const Brdf& brdf, const Vec3f& u, const Vec3f& v);

/// The weight of the Dirac part of a model, 0 for those that have none.
template <class Model>
Rgb mirror_of(const Model& model, const Vec3f& u) {
  if constexpr (requires { model.mirror(u); }) {
    return model.mirror(u);
  } else {
    return Rgb(0);
  }
}
Rgb mirror(const Brdf& brdf, const Vec3f& u);

/// A direction by the closed-form sampler of the model itself, and its density.
std::optional<DirectionSample> own_sample(const Brdf& brdf, const Vec3f& u, const Uniforms& xi);
float own_density(const Brdf& brdf, const Vec3f& u, const Vec3f& v);

// What a BRDF is made of, with the parameters that it has. A model that has a member of the same name says so
// itself; the others are guessed, so that a part is rather assumed than overlooked.

/// True if there is a Dirac part: guessed from `mirror`.
bool has_mirror(const Brdf& brdf);

/// True if there is anything besides a Dirac part.
bool has_density(const Brdf& brdf);

/// True if there is a matte part, which cosine-distributed directions serve: guessed from `kd`.
bool has_diffuse_part(const Brdf& brdf);

/// True if there is a lobe: a part that is neither matte nor a Dirac part. Guessed from `ks`, and for a model
/// without, true.
bool has_glossy_part(const Brdf& brdf);

/// True if turning both directions about the normal changes the value: guessed from the table.
bool is_anisotropic(const Brdf& brdf);

/// The exponents of a BRDF's cosine lobe, or nothing if it has none: guessed from `ex` and `ey`, or from `n`,
/// as of a lobe about the half vector. Of a sum, those of its widest lobe.
std::optional<LobeExponents> lobe_exponents(const Brdf& brdf);

std::vector<grf::ModelInfo> brdf_infos();

}  // namespace reflectance
