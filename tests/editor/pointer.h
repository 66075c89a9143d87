#pragma once

#include <QApplication>
#include <QMouseEvent>
#include <QWidget>

namespace test {

/// Sends a widget a move of the pointer, independently of the screen's pointer: QTest's own moves have no
/// buttons and send nothing if the pointer is there already.
inline void move_pointer(QWidget& widget, const QPointF& to, Qt::MouseButtons pressed = {},
                         Qt::KeyboardModifiers modifiers = {}) {
  QMouseEvent move(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, pressed, modifiers);
  QApplication::sendEvent(&widget, &move);
}

}  // namespace test
