#pragma once

#include <QThreadPool>
#include <QtConcurrent>
#include <numeric>
#include <vector>

namespace editor {

/// Calls `work(row)` for each row from 0 to count - 1 in parallel, on threads of its own: the caller may be a
/// task of the application's pool, whose threads would wait for each other.
template <class Work>
void for_each_row(int count, const Work& work) {
  std::vector<int> rows(static_cast<std::size_t>(count));
  std::iota(rows.begin(), rows.end(), 0);
  QThreadPool threads;
  QtConcurrent::blockingMap(&threads, rows, work);
}

}  // namespace editor
