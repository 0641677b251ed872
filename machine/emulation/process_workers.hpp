// SPDX-License-Identifier: MIT
// Workers that are processes of this host, so that one that dies takes nothing with it but its
// point.
#pragma once

#include "machine/emulation/point_workers.hpp"

#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace rasterloom::emulation {

class ProcessWorkers final : public PointWorkers {
  public:
    // The workers are copies of this process as it is now: to be made before threads are, and
    // before files are opened that they have no business with. They end with it, however it ends.
    // Throws std::system_error when the host has no room for a process.
    ProcessWorkers(std::size_t count, PointTask task);
    ProcessWorkers(const ProcessWorkers&) = delete;
    ProcessWorkers& operator=(const ProcessWorkers&) = delete;
    ~ProcessWorkers() override;

    std::size_t idle() const override;
    void start(std::size_t point) override;
    std::vector<FinishedPoint> wait(std::chrono::milliseconds longest) override;

  private:
    struct Worker {
        pid_t process = -1;
        int socket = -1;
        std::optional<std::size_t> point;  // that it is at
    };

    Worker make_worker() const;
    FinishedPoint finish(Worker& worker) const;

    PointTask task_;
    std::vector<Worker> workers_;
};

}  // namespace rasterloom::emulation
