// SPDX-License-Identifier: MIT
// Who runs the points of a sweep: each worker one at a time, all side by side.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace rasterloom::emulation {

// What a worker does with a point: its result as bytes. Must not throw.
using PointTask = std::function<std::string(std::size_t point)>;

struct FinishedPoint {
    std::size_t point = 0;
    std::string result;
    std::string loss;  // why there is no result: the worker has ended; empty: there is one
};

class PointWorkers {
  public:
    virtual ~PointWorkers() = default;

    // How many have nothing to do.
    virtual std::size_t idle() const = 0;
    // Hands a point to one of those.
    virtual void start(std::size_t point) = 0;
    // What has been finished since the last call; waits so long for the first.
    virtual std::vector<FinishedPoint> wait(std::chrono::milliseconds longest) = 0;
};

}  // namespace rasterloom::emulation
