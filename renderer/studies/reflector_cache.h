#pragma once

#include <memory>
#include <span>
#include <string>

#include "renderer/reflectance/brdf_instance.h"
#include "renderer/studies/study_cache.h"

namespace studies {

/// Returns a text that is the same for the same BRDF: with the definitions that a `combine` may use, and the
/// paths and times of data files.
std::string identity_of(const grf::BrdfModel& model, std::span<const grf::Definition> definitions = {});

/// Returns a BRDF with a sampling scheme that supports it, with the scheme's tables, which are built unless
/// the cache has them. The cache may be null.
std::shared_ptr<const reflectance::Reflector> cached_reflector(StudyCache* cache, const std::string& identity,
                                                               const reflectance::Brdf& brdf,
                                                               const grf::PdfModel& pdf);

}  // namespace studies
