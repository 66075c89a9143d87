// BRDFs that are dragged and copied.
#pragma once

#include <QMimeData>
#include <memory>
#include <optional>
#include <vector>

#include "grf/catalogue.h"
#include "grf/diagnostics.h"
#include "grf/model.h"

namespace editor {

/// The MIME type of a BRDF as GRF text, as it stands behind the word `brdf`.
inline constexpr const char* BrdfMimeType = "application/x-grf-brdf";
/// That of the name of a definition, beside the former where there is one: whoever knows the scene can share
/// it.
inline constexpr const char* BrdfNameMimeType = "application/x-grf-brdf-name";

/// A BRDF that needs no other file to be understood: written out instead of named by the file that holds it,
/// and its data file by the whole path.
grf::BrdfModel standing_alone(grf::BrdfModel brdf);

/// As both types of text and, of a definition, its name.
std::unique_ptr<QMimeData> mime_of(const grf::BrdfModel& brdf, const QString& definition_name = {});

/// The BRDF that is carried, or nothing and the reason: it cannot be read, or is none of the models. Whether
/// its values are right is not looked at.
std::optional<grf::BrdfModel> brdf_of(const QMimeData& mime, const std::vector<grf::ModelInfo>& models,
                                      grf::Diagnostics& diagnostics);

}  // namespace editor
