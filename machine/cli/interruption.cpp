// SPDX-License-Identifier: MIT
#include "machine/cli/interruption.hpp"

#include <array>

#include <pthread.h>

namespace rasterloom::cli {

namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
constexpr int kWakeUp = SIGURG;  // from the destructor to the watcher; nobody else sends it

bool is_ignored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

[[noreturn]] void die_by(int signal) {
    std::signal(signal, SIG_DFL);
    sigset_t only{};
    sigemptyset(&only);
    sigaddset(&only, signal);
    pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
    std::raise(signal);
    std::_Exit(128 + signal);
}

}  // namespace

Interruption::Interruption(const std::function<void()>& prepare, std::function<void()> clean_up)
    : clean_up_(std::move(clean_up)) {
    sigemptyset(&awaited_);
    sigaddset(&awaited_, kWakeUp);
    for (const int signal : kSignals) {
        if (!is_ignored(signal)) {
            sigaddset(&awaited_, signal);
        }
    }
    // Threads inherit the mask: the signals reach nobody but who waits for them.
    pthread_sigmask(SIG_BLOCK, &awaited_, &mask_before_);
    try {
        prepare();
    } catch (...) {
        pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
        throw;
    }
    watcher_ = std::thread([this] { watch(); });
}

Interruption::~Interruption() {
    over_ = true;
    pthread_kill(watcher_.native_handle(), kWakeUp);
    watcher_.join();
    pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
}

void Interruption::watch() {
    while (!over_) {
        int signal = 0;
        if (sigwait(&awaited_, &signal) == 0 && signal != kWakeUp) {
            clean_up_();
            die_by(signal);
        }
    }
}

}  // namespace rasterloom::cli
