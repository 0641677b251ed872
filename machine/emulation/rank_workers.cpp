// SPDX-License-Identifier: MIT
// Two kinds of message: from the first rank the number of a point, or that there are no more; to it
// a point's result. Whoever waits sleeps between two looks: MPI's own waiting takes a whole core,
// which the rank's workers have a better use for.
#include "machine/emulation/rank_workers.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <mpi.h>

namespace rasterloom::emulation {

namespace {

constexpr int kFirst = 0;      // rank
constexpr int kPointTag = 1;   // to a rank: a point's number or kNoMore
constexpr int kResultTag = 2;  // from it: the number, whether the worker was lost, the text
constexpr int kGoneTag = 3;    // from it, last of all
constexpr std::uint64_t kNoMore = ~std::uint64_t{0};
constexpr std::chrono::milliseconds kBetweenLooks{1};

class Job {
  public:
    Job() {
        MPI_Init(nullptr, nullptr);
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
    }
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;
    ~Job() { MPI_Finalize(); }

    int rank() const { return rank_; }
    int ranks() const { return ranks_; }

  private:
    int rank_ = 0;
    int ranks_ = 1;
};

struct Message {
    int from = 0;
    int tag = 0;
    std::string bytes;
};

void send(int rank, int tag, const std::string& bytes) {
    MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, rank, tag, MPI_COMM_WORLD);
}

// The next message if there is one.
std::optional<Message> receive() {
    int there = 0;
    MPI_Status status{};
    MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
    if (there == 0) {
        return std::nullopt;
    }
    int size = 0;
    MPI_Get_count(&status, MPI_BYTE, &size);
    Message message{status.MPI_SOURCE, status.MPI_TAG,
                    std::string(static_cast<std::size_t>(size), '\0')};
    MPI_Recv(message.bytes.data(), size, MPI_BYTE, message.from, message.tag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    return message;
}

// All ranks are of one kind of host.
std::string number_bytes(std::uint64_t number) {
    std::string bytes(sizeof number, '\0');
    std::memcpy(bytes.data(), &number, sizeof number);
    return bytes;
}

std::uint64_t number_of(const std::string& bytes) {
    std::uint64_t number = kNoMore;
    std::memcpy(&number, bytes.data(), std::min(sizeof number, bytes.size()));
    return number;
}

std::string pack(const FinishedPoint& finished) {
    const bool lost = !finished.loss.empty();
    return number_bytes(finished.point) + (lost ? '!' : ' ') +
           (lost ? finished.loss : finished.result);
}

FinishedPoint unpack(const std::string& bytes) {
    FinishedPoint finished{number_of(bytes), {}, {}};
    const bool lost = bytes.at(sizeof(std::uint64_t)) == '!';
    (lost ? finished.loss : finished.result) = bytes.substr(sizeof(std::uint64_t) + 1);
    return finished;
}

// Of a rank that is not the first: how many of its workers have nothing to do.
struct Peer {
    int rank = 0;
    std::size_t idle = 0;
};

class RankWorkers final : public PointWorkers {
  public:
    // Every rank has as many workers as this one.
    RankWorkers(PointWorkers& own, int ranks) : own_(own) {
        for (int rank = kFirst + 1; rank < ranks; ++rank) {
            peers_.push_back({rank, own.idle()});
        }
    }
    RankWorkers(const RankWorkers&) = delete;
    RankWorkers& operator=(const RankWorkers&) = delete;
    ~RankWorkers() override {
        for (const Peer& peer : peers_) {
            send(peer.rank, kPointTag, number_bytes(kNoMore));
        }
        // A rank may have been sending a result that nobody wants any more.
        for (std::size_t gone = 0; gone < peers_.size();) {
            if (const auto message = receive()) {
                gone += message->tag == kGoneTag ? 1 : 0;
            } else {
                own_.wait(kBetweenLooks);
            }
        }
    }

    std::size_t idle() const override {
        std::size_t sum = own_.idle();
        for (const Peer& peer : peers_) {
            sum += peer.idle;
        }
        return sum;
    }

    void start(std::size_t point) override {
        if (own_.idle() > 0) {
            own_.start(point);
            return;
        }
        const auto peer = std::find_if(peers_.begin(), peers_.end(),
                                       [](const Peer& candidate) { return candidate.idle > 0; });
        --peer->idle;
        send(peer->rank, kPointTag, number_bytes(point));
    }

    std::vector<FinishedPoint> wait(std::chrono::milliseconds longest) override {
        const auto end = std::chrono::steady_clock::now() + longest;
        std::vector<FinishedPoint> finished;
        do {
            while (const auto message = receive()) {
                finished.push_back(unpack(message->bytes));
                ++peers_[static_cast<std::size_t>(message->from - kFirst - 1)].idle;
            }
            for (FinishedPoint& point :
                 own_.wait(finished.empty() ? kBetweenLooks : std::chrono::milliseconds(0))) {
                finished.push_back(std::move(point));
            }
        } while (finished.empty() && std::chrono::steady_clock::now() < end);
        return finished;
    }

  private:
    PointWorkers& own_;
    std::vector<Peer> peers_;
};

// The life of every other rank.
void lend(PointWorkers& own) {
    while (true) {
        if (const auto message = receive()) {
            const std::uint64_t point = number_of(message->bytes);
            if (point == kNoMore) {
                break;
            }
            own.start(point);
        }
        for (const FinishedPoint& finished : own.wait(kBetweenLooks)) {
            send(kFirst, kResultTag, pack(finished));
        }
    }
    send(kFirst, kGoneTag, {});
}

}  // namespace

bool has_mpi() {
    return true;
}

bool run_on_ranks(PointWorkers* own, const std::function<void(PointWorkers& all)>& work) {
    const Job job;
    // The first rank that cannot; all ranks learn it before one of them ends, since the first to
    // end with an error takes the others with it.
    const int mine = own == nullptr ? job.rank() : job.ranks();
    int unable = mine;
    MPI_Allreduce(&mine, &unable, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
    if (unable < job.ranks()) {
        return unable == job.rank();
    }
    if (job.rank() != kFirst) {
        try {
            lend(*own);
        } catch (const std::exception& error) {
            // The first rank would wait for it for ever.
            fmt::print(stderr, "rasterloom: rank {}: {}\n", job.rank(), error.what());
            MPI_Abort(MPI_COMM_WORLD, 1);
        }
        return false;
    }
    RankWorkers all(*own, job.ranks());
    work(all);
    return false;
}

}  // namespace rasterloom::emulation
