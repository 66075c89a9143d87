// BRDFs are dragged, dropped and copied under MIME types of their own.
#pragma once

#include <QMimeData>
#include <memory>
#include <optional>
#include <vector>

#include "grf/catalogue.h"
#include "grf/diagnostics.h"
#include "grf/model.h"

namespace editor {

/// The MIME type of a BRDF as GRF text, as it follows the keyword `brdf`.
inline constexpr const char* BrdfMimeType = "application/x-grf-brdf";
/// The MIME type of the name of its definition, if any, so that a receiver with the same scene can share it.
inline constexpr const char* BrdfNameMimeType = "application/x-grf-brdf-name";

/// Makes a BRDF independent of other files: one that is named by its file is written out, and its data file
/// gets an absolute path.
grf::BrdfModel self_contained(grf::BrdfModel brdf);

/// Encodes a BRDF in both text types and, for a definition, its name.
std::unique_ptr<QMimeData> mime_of(const grf::BrdfModel& brdf, const QString& definition_name = {});

/// Decodes a BRDF, or reports that it cannot be read or is an unknown model. Its values are not checked.
std::optional<grf::BrdfModel> brdf_of(const QMimeData& mime, const std::vector<grf::ModelInfo>& models,
                                      grf::Diagnostics& diagnostics);

}  // namespace editor
