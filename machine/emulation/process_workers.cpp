// SPDX-License-Identifier: MIT
#include "machine/emulation/process_workers.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rasterloom::emulation {

namespace {

[[noreturn]] void fail(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

// All of it, or false: the other side has gone.
bool send_all(int socket, const void* data, std::size_t size) {
    const char* at = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t sent = ::send(socket, at, size, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) {
            continue;
        }
        if (sent <= 0) {
            return false;
        }
        at += sent;
        size -= static_cast<std::size_t>(sent);
    }
    return true;
}

bool receive_all(int socket, void* data, std::size_t size) {
    char* at = static_cast<char*>(data);
    while (size > 0) {
        const ssize_t received = ::recv(socket, at, size, 0);
        if (received < 0 && errno == EINTR) {
            continue;
        }
        if (received <= 0) {
            return false;
        }
        at += received;
        size -= static_cast<std::size_t>(received);
    }
    return true;
}

// A worker's whole life. Numbers are in the host's own form: both sides are this host.
[[noreturn]] void serve(int socket, const PointTask& task) {
    std::uint64_t point = 0;
    while (receive_all(socket, &point, sizeof point)) {
        const std::string result = task(point);
        const std::uint64_t size = result.size();
        if (!send_all(socket, &size, sizeof size) || !send_all(socket, result.data(), size)) {
            break;
        }
    }
    // No destructors: what this process has of the other's is a copy.
    ::_exit(0);
}

std::string end_of(int status) {
    if (WIFSIGNALED(status)) {
        return fmt::format("the process that ran it was ended by signal {} ({})", WTERMSIG(status),
                           ::sigdescr_np(WTERMSIG(status)));
    }
    return fmt::format("the process that ran it ended with status {}", WEXITSTATUS(status));
}

}  // namespace

ProcessWorkers::ProcessWorkers(std::size_t count, PointTask task) : task_(std::move(task)) {
    for (std::size_t i = 0; i < count; ++i) {
        workers_.push_back(make_worker());
    }
}

ProcessWorkers::~ProcessWorkers() {
    for (const Worker& worker : workers_) {
        // One that still runs a point is not waited for: nobody wants its result any more.
        ::kill(worker.process, SIGKILL);
        ::close(worker.socket);
        ::waitpid(worker.process, nullptr, 0);
    }
}

ProcessWorkers::Worker ProcessWorkers::make_worker() const {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        fail("socketpair");
    }
    const pid_t parent = ::getpid();
    const pid_t child = ::fork();
    if (child < 0) {
        ::close(ends[0]);
        ::close(ends[1]);
        fail("fork");
    }
    if (child == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (::getppid() != parent) {
            ::_exit(0);  // it died before that was said
        }
        // Everything else that the parent has open, its other sockets and its locks among it, ends
        // when the parent does.
        constexpr int kSocket = 3;
        if (ends[1] != kSocket) {
            ::dup2(ends[1], kSocket);
        }
        ::close_range(kSocket + 1, ~0U, 0);
        serve(kSocket, task_);
    }
    ::close(ends[1]);
    return {child, ends[0], std::nullopt};
}

std::size_t ProcessWorkers::idle() const {
    return static_cast<std::size_t>(
        std::count_if(workers_.begin(), workers_.end(),
                      [](const Worker& worker) { return !worker.point.has_value(); }));
}

void ProcessWorkers::start(std::size_t point) {
    const auto worker = std::find_if(workers_.begin(), workers_.end(), [](const Worker& candidate) {
        return !candidate.point.has_value();
    });
    worker->point = point;
    const std::uint64_t number = point;
    send_all(worker->socket, &number, sizeof number);  // a loss shows when the result is read
}

std::vector<FinishedPoint> ProcessWorkers::wait(std::chrono::milliseconds longest) {
    std::vector<pollfd> waiting;
    std::vector<Worker*> of;
    for (Worker& worker : workers_) {
        if (worker.point) {
            waiting.push_back({worker.socket, POLLIN, 0});
            of.push_back(&worker);
        }
    }
    std::vector<FinishedPoint> finished;
    if (::poll(waiting.data(), waiting.size(), static_cast<int>(longest.count())) <= 0) {
        return finished;
    }
    for (std::size_t i = 0; i < waiting.size(); ++i) {
        if (waiting[i].revents != 0) {
            finished.push_back(finish(*of[i]));
        }
    }
    return finished;
}

FinishedPoint ProcessWorkers::finish(Worker& worker) const {
    FinishedPoint finished{*worker.point, {}, {}};
    std::uint64_t size = 0;
    bool whole = receive_all(worker.socket, &size, sizeof size);
    if (whole) {
        finished.result.resize(size);
        whole = receive_all(worker.socket, finished.result.data(), size);
    }
    worker.point.reset();
    if (!whole) {
        int status = 0;
        ::close(worker.socket);
        ::waitpid(worker.process, &status, 0);
        finished.loss = end_of(status);
        worker = make_worker();
    }
    return finished;
}

}  // namespace rasterloom::emulation
