#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/visit.h"
#include "renderer/reflectance/brdf_maker.h"
#include "renderer/reflectance/reflector.h"
#include "renderer/reflectance/varying_brdf.h"

namespace transport {

/// A sampling scheme that replaces those of the scene, or only that of the faces with one BRDF and scheme.
struct SchemeOverride {
  grf::PdfModel model;
  std::string factors_file;  ///< the scheme `factored` loads it instead of factoring; empty: none
  std::string brdf = {};     ///< of these faces, as in TableInfo; empty: all faces
  std::string scheme = {};   ///< likewise

  bool operator==(const SchemeOverride&) const = default;
};

/// Returns the text of a surface's BRDF, or of GRF's default for null.
std::string brdf_text(const grf::BrdfModel* brdf);
/// Returns the text of a surface's sampling scheme, or of the default for null.
std::string scheme_text(const grf::PdfModel* scheme);

/// The tables of a reflector.
struct TableInfo {
  std::string brdf;    ///< as written in the scene
  std::string scheme;  ///< likewise
  std::size_t bytes = 0;
  float cosine_fraction = 0;  ///< see Reflector
};

/// The reflectors of a scene, one per pair of BRDF and sampling scheme in use.
struct ReflectorSet {
  std::vector<reflectance::Reflector> reflectors;
  std::vector<TableInfo> tables;  ///< one per reflector
  /// Cache key for each reflector; empty if it must not be reused.
  std::vector<std::string> identities;
  double seconds = 0;  ///< to build them
};

/// Collects pairs of BRDFs and schemes, then builds their reflectors. The scene must not change meanwhile.
class ReflectorSetBuilder {
 public:
  /// Reuses reflectors of the set `before`, if there is one.
  ReflectorSetBuilder(const std::optional<SchemeOverride>& scheme, reflectance::MissedPart missed_part,
                      reflectance::Precision precision, grf::Diagnostics& diagnostics,
                      const ReflectorSet* before = nullptr)
      : before_(before),
        override_(scheme),
        missed_part_(missed_part),
        precision_(precision),
        diagnostics_(diagnostics),
        brdfs_(diagnostics) {}

  /// Returns the index of the reflector that will serve a surface; after an error, any index.
  std::uint32_t index_of(const grf::ResolvedSurface& surface);
  /// The BRDF if images vary it, else null.
  std::shared_ptr<const reflectance::VaryingBrdf> varying(std::uint32_t index) const {
    return index < pairs_.size() ? pairs_[index].varying : nullptr;
  }
  bool is_anisotropic(std::uint32_t index) const;

  /// The BRDF if it is glass, else null; invalid once another index was asked for.
  const reflectance::Glass* glass(std::uint32_t index) const {
    return index < pairs_.size() ? std::get_if<reflectance::Glass>(&pairs_[index].brdf) : nullptr;
  }
  /// Whether it has neither a glossy nor a specular part.
  bool is_diffuse(std::uint32_t index) const;
  /// Whether the BRDF depends on a file.
  bool reads_data(const grf::ResolvedSurface& surface);

  /// Builds the tables of all reflectors in parallel, and warns of schemes that miss part of their BRDF.
  /// There must have been no error. Tables that were not begun when a stop was requested are missing.
  ReflectorSet build(const std::stop_token& stop = {});

 private:
  struct Pair {
    reflectance::Brdf brdf;
    reflectance::Scheme scheme;
    std::string identity;
    const reflectance::Reflector* known = nullptr;  ///< of the set `before`
    std::string brdf_keyword;
    TableInfo info;
    std::string scheme_keyword;
    grf::SourceLocation scheme_location;
    std::shared_ptr<const reflectance::VaryingBrdf> varying = nullptr;
  };

  bool is_overridden(const grf::ResolvedSurface& surface) const;
  const grf::PdfModel* scheme_of(const grf::ResolvedSurface& surface) const {
    return override_ && is_overridden(surface) ? &override_->model : surface.pdf;
  }
  std::uint32_t index_by_text(const grf::ResolvedSurface& surface);
  std::uint32_t add(const grf::ResolvedSurface& surface, const std::string& text);
  bool make_varying(const grf::BrdfModel& brdf, Pair& pair);
  std::string identity_of(const grf::ResolvedSurface& surface, const std::string& text);
  const reflectance::Reflector* known(const std::string& identity) const;
  bool use_factors_file(const grf::ResolvedSurface& surface, Pair& pair);
  void warn_of_what_is_missed(const Pair& pair, const reflectance::Reflector& reflector);

  const ReflectorSet* before_;
  std::optional<SchemeOverride> override_;
  reflectance::MissedPart missed_part_;
  reflectance::Precision precision_;
  grf::Diagnostics& diagnostics_;
  reflectance::BrdfMaker brdfs_;
  std::map<std::string, std::uint32_t> index_by_text_;
  /// Models that do not depend on the scope, by their address in the scene: thousands of instances look up
  /// the same ones.
  std::map<std::pair<const grf::BrdfModel*, const grf::PdfModel*>, std::uint32_t> index_by_place_;
  std::vector<Pair> pairs_;
  double seconds_ = 0;  ///< for tables built before `build`
};

}  // namespace transport
