// Giving selected faces a BRDF that was dragged from a library, the scene's list or another program.
#pragma once

#include <QMimeData>

#include "editor/document/document.h"
#include "grf/catalogue.h"

namespace editor {

/// Gives the selected faces what is carried (see document/brdf_mime.h), as one step of undo: the definition
/// by its name where that means this BRDF for all of the faces, else the BRDF written out. False, and nothing
/// changed, if no face is selected, nothing can be read, or values are not right, with the reason in the
/// diagnostics.
bool assign_brdf(Document& document, const grf::Catalogue& catalogue, const QMimeData& mime,
                 grf::Diagnostics& diagnostics);

}  // namespace editor
