#pragma once

namespace editor {

/// How long a control waits after the last key or turn of the wheel before its gesture is one undo step, in
/// milliseconds.
inline constexpr int SettlingMilliseconds = 400;

}  // namespace editor
