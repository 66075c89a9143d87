#pragma once

#include <vector>

class QWidget;

namespace editor {

/// Sets the tab order: through the controls of the first of these widgets, then of the next, in creation
/// order. Qt keeps that order only for widgets created once; later or moved ones it puts last in the window.
/// The first widget keeps its place, and has a control.
void lead_tab_through(const std::vector<QWidget*>& parts);

}  // namespace editor
