#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "grf/catalogue.h"
#include "renderer/reflectance/schemes/adaptive_scheme.h"
#include "renderer/reflectance/schemes/anisotropic_scheme.h"
#include "renderer/reflectance/schemes/auto_scheme.h"
#include "renderer/reflectance/schemes/cascade_scheme.h"
#include "renderer/reflectance/schemes/diffuse_scheme.h"
#include "renderer/reflectance/schemes/factored_scheme.h"
#include "renderer/reflectance/schemes/hemisphere_scheme.h"
#include "renderer/reflectance/schemes/own_scheme.h"
#include "renderer/reflectance/schemes/reject_scheme.h"
#include "renderer/reflectance/schemes/specular_scheme.h"
#include "renderer/reflectance/schemes/sphere_scheme.h"

namespace reflectance {

/// All sampling schemes: the one list that a new scheme is added to. A scheme is one file of `schemes` with
///   table()           its keyword and parameters,
///   refusal(brdf)     why it cannot serve a BRDF, and what can; empty if it does,
///   sample(brdf, u, xi), density(brdf, u, v)    for all of the BRDF but its Dirac part,
/// and where it keeps tables, which then serve that BRDF alone,
///   build(brdf)       makes them, on all cores,
///   bytes()           the memory that they hold.
/// `MayMiss` says that some BRDFs reflect light into directions that the scheme draws never or hardly ever:
/// Reflector mixes it with a cosine part for those. `sample_many` is there where many samples for one view
/// cost less than as many single ones.
using AnyScheme =
    std::variant<AutoScheme, OwnScheme, DiffuseScheme, SpecularScheme, HemisphereScheme, SphereScheme,
                 AnisotropicScheme, RejectScheme, AdaptiveScheme, FactoredScheme, CascadeScheme>;

/// One of them. It is a class for the same reason as Brdf.
class Scheme : public AnyScheme {
 public:
  using AnyScheme::AnyScheme;
  Scheme();
  ~Scheme();
  Scheme(const Scheme& other);
  Scheme(Scheme&& other) noexcept;
  Scheme& operator=(const Scheme& other);
  Scheme& operator=(Scheme&& other) noexcept;
};

/// The scheme that a `pdf` of the scene describes, without its tables, or nothing if none has its keyword.
std::optional<Scheme> make_scheme(const grf::Model& data);

/// What a face without a `pdf` has: `auto`.
Scheme default_scheme();

std::string refusal(const Scheme& scheme, const Brdf& brdf);

/// Makes the tables of a scheme for a BRDF that it does not refuse.
void build(Scheme& scheme, const Brdf& brdf);

/// What the tables of a scheme hold, in bytes; 0 for schemes without.
std::size_t bytes(const Scheme& scheme);

/// True if the scheme may leave out part of what some BRDFs reflect.
bool may_miss(const Scheme& scheme);

std::optional<DirectionSample> sample(const Scheme& scheme, const Brdf& brdf, const Vec3f& u,
                                      const Uniforms& xi);
float density(const Scheme& scheme, const Brdf& brdf, const Vec3f& u, const Vec3f& v);

/// Adds a sample for each xi, without those that are empty, all for one view: cheaper or spread more evenly
/// than one by one with schemes that have a `sample_many`. Each alone has the scheme's density, and an
/// estimate is their sum over the number of xi.
void sample_many(const Scheme& scheme, const Brdf& brdf, const Vec3f& u, std::span<const Uniforms> xi,
                 std::vector<DirectionSample>& out);

std::vector<grf::ModelInfo> scheme_infos();

/// All BRDFs and sampling schemes, for `grf::check`.
grf::Catalogue catalogue();

}  // namespace reflectance
