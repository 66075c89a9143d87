#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "grf/diagnostics.h"
#include "grf/visit.h"
#include "renderer/reflectance/brdf_maker.h"
#include "renderer/reflectance/reflector.h"

namespace transport {

/// A sampling scheme in place of those of the scene.
struct SchemeOverride {
  grf::PdfModel model;
  std::string factors_file;  ///< of the scheme `factored`: what it loads instead of factoring; empty: nothing

  bool operator==(const SchemeOverride&) const = default;
};

/// What a reflector's tables hold.
struct TableInfo {
  std::string brdf;    ///< as a scene writes it
  std::string scheme;  ///< likewise
  std::size_t bytes = 0;
  float cosine_share = 0;  ///< see Reflector
};

/// The reflectors of a scene, one for each pair of BRDF and scheme that is in use.
struct ReflectorSet {
  std::vector<reflectance::Reflector> reflectors;
  std::vector<TableInfo> tables;  ///< of each of them
  /// Of each, a text that is the same for those that are the same; empty: there is none.
  std::vector<std::string> identities;
  double seconds = 0;  ///< that building them took
};

/// Collects pairs of BRDFs and schemes, and then makes their reflectors. The scene must not change meanwhile.
class ReflectorSetBuilder {
 public:
  /// What is in the set `before`, if there is one, is taken from there.
  ReflectorSetBuilder(const std::optional<SchemeOverride>& scheme, reflectance::MissedPart missed_part,
                      reflectance::Precision precision, grf::Diagnostics& diagnostics,
                      const ReflectorSet* before = nullptr)
      : before_(before),
        override_(scheme),
        missed_part_(missed_part),
        precision_(precision),
        diagnostics_(diagnostics),
        brdfs_(diagnostics) {}

  /// Which reflector will serve a surface; after an error, any.
  std::uint32_t index_of(const grf::ResolvedSurface& surface);
  bool is_anisotropic(std::uint32_t index) const {
    return index < pairs_.size() && reflectance::is_anisotropic(pairs_[index].brdf);
  }

  /// True if it has neither a glossy nor a mirror part.
  bool is_matte(std::uint32_t index) const {
    return index < pairs_.size() && !reflectance::has_glossy_part(pairs_[index].brdf) &&
           !reflectance::has_mirror(pairs_[index].brdf);
  }
  /// Whether a file is needed to know the BRDF.
  bool reads_data(const grf::ResolvedSurface& surface);

  /// Makes the tables of all of them, in parallel, and warns of schemes that miss part of their BRDF. There
  /// must have been no error. Those that are not begun when it is told to stop are missing then.
  ReflectorSet build(const std::stop_token& stop = {});

 private:
  struct Pair {
    reflectance::Brdf brdf;
    reflectance::Scheme scheme;
    std::string identity;
    const reflectance::Reflector* known = nullptr;  ///< of the set before
    std::string brdf_keyword;
    TableInfo info;
    std::string scheme_keyword;
    grf::SourceLocation scheme_location;
  };

  const grf::PdfModel* scheme_of(const grf::ResolvedSurface& surface) const {
    return override_ ? &override_->model : surface.pdf;
  }
  std::uint32_t index_by_text(const grf::ResolvedSurface& surface);
  std::uint32_t add(const grf::ResolvedSurface& surface, const std::string& text);
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
  /// Of models that are what they are in every scope, by where they stand in the scene: thousands of
  /// instances ask for the same ones.
  std::map<std::pair<const grf::BrdfModel*, const grf::PdfModel*>, std::uint32_t> index_by_place_;
  std::vector<Pair> pairs_;
  double seconds_ = 0;  ///< that tables took which are made before `build`
};

}  // namespace transport
