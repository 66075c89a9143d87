#pragma once

class QMainWindow;

namespace editor {

/// Opens a searchable list of all actions of a window with their shortcuts, by menus and by controls with
/// their own keys, and of the gestures in the 3D view. Return or a double click runs an action. The list
/// stays open beside the window until then.
void show_shortcuts(QMainWindow& window);

}  // namespace editor
