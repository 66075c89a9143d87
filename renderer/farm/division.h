// A stage of an image is divided into tasks for the machines of a farm.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/farm/records.h"
#include "renderer/farm/stages.h"

namespace farm {

/// These limits hold for each task.
struct TaskLimits {
  double seconds = 2;             ///< of one thread, which a task takes about
  std::size_t bytes = 1U << 20U;  ///< of a part file, at most, as far as a tile is smaller
};

/// Returns the bytes of a part file that has samples of one of this many tiles.
std::size_t tile_bytes(int tiles);

/// Divides a stage, each sample of which takes so many seconds of one thread, into tasks with numbers from
/// `first_number`. A task has all samples of consecutive tiles, as its part file has a size for each tile
/// that it has samples of; or, where that takes too long, some samples of one tile, unless it is a pilot.
/// Tasks together have each sample once.
std::vector<Task> divide(const Stage& stage, int first_number, double seconds_per_sample,
                         const TaskLimits& limits);

}  // namespace farm
