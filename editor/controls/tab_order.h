#pragma once

#include <vector>

class QWidget;

namespace editor {

/// Has Tab lead through the controls in the first of these parts of a window, then through those in the next,
/// in the order in which they were made. Qt keeps that order by itself for what is made once; what comes
/// later, or changes places, it leaves behind all of the window. The first part stays where it is, and has a
/// control.
void lead_tab_through(const std::vector<QWidget*>& parts);

}  // namespace editor
