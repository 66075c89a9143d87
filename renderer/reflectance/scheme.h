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

/// All sampling schemes (`pdf` in a scene): the only list that a new scheme is added to. A scheme is a file
/// of `schemes` with
///   table()                    its keyword and parameters,
///   unsupported_reason(brdf)   why it does not support a BRDF, and what does; empty if it does,
///   sample(brdf, u, xi), pdf(brdf, u, v)    for the BRDF without its delta part,
/// and if it keeps tables, which then serve only that BRDF,
///   build(brdf)                makes them, on all cores,
///   bytes()                    their memory.
/// `IsIncomplete` means that its pdf is 0 or nearly so where some BRDFs reflect light: Reflector then mixes
/// in cosine sampling. `sample_many` exists where a batch of samples for one view is cheaper than single
/// ones.
using AnyScheme =
    std::variant<AutoScheme, OwnScheme, DiffuseScheme, SpecularScheme, HemisphereScheme, SphereScheme,
                 AnisotropicScheme, RejectScheme, AdaptiveScheme, FactoredScheme, CascadeScheme>;

/// A sampling scheme of any type. It is a class for the same reason as Brdf.
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

/// Makes the scheme of a scene's `pdf`, without tables, or returns nothing if none has its keyword.
std::optional<Scheme> make_scheme(const grf::Model& data);

/// Returns the scheme of a face without a `pdf`: `auto`.
Scheme default_scheme();

/// Returns why a scheme cannot sample a BRDF; empty if it can.
std::string unsupported_reason(const Scheme& scheme, const Brdf& brdf);

/// Builds the tables of a scheme for a BRDF that it supports.
void build(Scheme& scheme, const Brdf& brdf);

/// Returns the memory of a scheme's tables, in bytes; 0 if it has none.
std::size_t bytes(const Scheme& scheme);

/// Returns true if the scheme keeps tables that serve one BRDF only.
bool is_tabulated(const Scheme& scheme);

/// Returns true if the scheme's pdf may be 0 where some BRDFs reflect light.
bool is_incomplete(const Scheme& scheme);

/// Draws a direction, and returns the pdf of any direction: see model.h.
std::optional<DirectionSample> sample(const Scheme& scheme, const Brdf& brdf, const Vec3f& u,
                                      const Uniforms& xi);
float pdf(const Scheme& scheme, const Brdf& brdf, const Vec3f& u, const Vec3f& v);

/// Appends a sample per xi, without empty ones, all for one view: cheaper or better stratified than single
/// samples for schemes that have a `sample_many`. Each sample has the scheme's pdf; an estimate is their sum
/// over the number of xi.
void sample_many(const Scheme& scheme, const Brdf& brdf, const Vec3f& u, std::span<const Uniforms> xi,
                 std::vector<DirectionSample>& out);

/// Returns the descriptions of all schemes, in the order of the documents.
std::vector<grf::ModelInfo> scheme_infos();

/// Returns the catalogue of all BRDFs and sampling schemes, for `grf::check`.
grf::Catalogue catalogue();

}  // namespace reflectance
