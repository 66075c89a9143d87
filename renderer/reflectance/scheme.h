#pragma once

#include <string>
#include <variant>
#include <vector>

#include "grf/catalogue.h"
#include "renderer/reflectance/auto_scheme.h"
#include "renderer/reflectance/diffuse_scheme.h"
#include "renderer/reflectance/specular_scheme.h"

namespace reflectance {

/// All sampling schemes: the one list that a new scheme is added to. A scheme is one file with
///   table()                   its keyword and parameters,
///   refusal(brdf)             why it cannot serve a BRDF, and what can; empty if it does,
///   sample(brdf, u, xi), density(brdf, u, v)    for all of the BRDF but its Dirac part.
using Scheme = std::variant<AutoScheme, DiffuseScheme, SpecularScheme>;

/// The scheme that a `pdf` of the scene describes, or nothing if none has its keyword.
std::optional<Scheme> make_scheme(const grf::Model& data);

/// What a face without a `pdf` has: `auto`.
Scheme default_scheme();

std::string refusal(const Scheme& scheme, const Brdf& brdf);

std::vector<grf::ModelInfo> scheme_infos();

/// All BRDFs and sampling schemes, for `grf::check`.
grf::Catalogue catalogue();

}  // namespace reflectance
