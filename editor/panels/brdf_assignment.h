// Assigns a BRDF that was dragged from a library, the scene tree or another program to the selected faces.
#pragma once

#include <QMimeData>

#include "editor/document/document.h"
#include "grf/catalogue.h"

namespace editor {

/// Assigns the dragged BRDF (see document/brdf_mime.h) to the selected faces as one undo step: by the name of
/// its definition if that means this BRDF for all of the faces, else written out. Returns false, changes
/// nothing and reports why in the diagnostics if no face is selected, nothing can be read, or values are
/// invalid.
bool assign_brdf(Document& document, const grf::Catalogue& catalogue, const QMimeData& mime,
                 grf::Diagnostics& diagnostics);

}  // namespace editor
