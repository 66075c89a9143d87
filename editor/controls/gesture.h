#pragma once

namespace editor {

/// How long a control waits after the last key press or wheel turn before it commits an undo step, in
/// milliseconds.
inline constexpr int SettlingMilliseconds = 400;

}  // namespace editor
