#pragma once

#include <QPoint>

namespace editor {

/// How long a control waits after the last key press or wheel turn before it commits an undo step, in
/// milliseconds.
inline constexpr int SettlingMilliseconds = 400;

/// Returns the direction of an arrow key, x to the right and y up; null for other keys.
inline QPoint arrow_way(int key) {
  const auto way = [key](int forwards, int backwards) {
    return key == forwards ? 1 : key == backwards ? -1 : 0;
  };
  return {way(Qt::Key_Right, Qt::Key_Left), way(Qt::Key_Up, Qt::Key_Down)};
}

}  // namespace editor
