// SPDX-License-Identifier: MIT
#include "machine/emulation/sweep.hpp"

#include "machine/emulation/sweep_point.hpp"
#include "machine/observe/output_folder.hpp"
#include "machine/observe/sweep/folder_lock.hpp"
#include "machine/observe/sweep/sweep_table.hpp"

#include <chrono>
#include <deque>
#include <map>
#include <utility>
#include <vector>

namespace rasterloom::emulation {

namespace {

using WallClock = std::chrono::steady_clock;
using observe::SweepTable;

constexpr int kTries = 2;
constexpr std::chrono::milliseconds kLongestWait{500};  // between two looks at the time left

std::vector<std::string> names_of(const std::vector<config::SweepParameter>& parameters) {
    std::vector<std::string> names;
    for (const config::SweepParameter& parameter : parameters) {
        names.push_back(parameter.key);
    }
    return names;
}

class SweepRun {
  public:
    SweepRun(const config::SweepDescription& sweep, const config::Locator& locator,
             PointWorkers& workers, const SweepOptions& options)
        : sweep_(sweep),
          locator_(locator),
          workers_(workers),
          options_(options),
          csv_(options.folder / "results.csv"),
          lock_(options.folder),
          table_(options.folder / "results.sqlite", names_of(sweep.parameters),
                 options.fresh ? SweepTable::Start::anew : SweepTable::Start::go_on) {
        progress_.points = sweep.size();
        observe::remove_unfinished(csv_);
    }

    SweepProgress run() {
        find_what_is_missing();
        while (progress_.done < progress_.points) {
            hand_out();
            const std::vector<observe::SweepRow> rows = rows_of(workers_.wait(kLongestWait));
            hand_out();  // nobody waits for the disk
            if (!rows.empty()) {
                table_.add(rows);
            }
            progress_.done += rows.size();
            tell();
        }
        observe::write_file_whole(csv_, table_.csv());
        return progress_;
    }

  private:
    void find_what_is_missing() {
        for (std::size_t i = 0; i < progress_.points; ++i) {
            const config::SweepPoint point = sweep_.point(i);
            const auto known = table_.known().find(point.key);
            const bool is_there = known != table_.known().end() &&
                                  !(known->second.failed && options_.retry_failed) &&
                                  known->second.fingerprint == fingerprint(point, locator_);
            if (is_there) {
                ++progress_.before;
                progress_.failed += known->second.failed ? 1 : 0;
            } else {
                missing_.push_back(i);
            }
        }
        progress_.done = progress_.before;
    }

    void hand_out() {
        while (!missing_.empty() && workers_.idle() > 0) {
            workers_.start(missing_.front());
            missing_.pop_front();
        }
    }

    std::vector<observe::SweepRow> rows_of(const std::vector<FinishedPoint>& finished) {
        std::vector<observe::SweepRow> rows;
        for (const FinishedPoint& point : finished) {
            if (!point.loss.empty() && ++losses_[point.point] < kTries) {
                missing_.push_back(point.point);
                continue;
            }
            config::SweepPoint of = sweep_.point(point.point);
            observe::SweepResult result = result_of(point, of);
            progress_.failed += result.error.empty() ? 0 : 1;
            rows.push_back({std::move(of.key), std::move(of.config.text), std::move(of.scene),
                            std::move(of.values), std::move(result)});
        }
        return rows;
    }

    observe::SweepResult result_of(const FinishedPoint& finished,
                                   const config::SweepPoint& point) const {
        if (finished.loss.empty()) {
            return observe::decode_result(finished.result);
        }
        observe::SweepResult result = observe::failed_result(finished.loss);
        result.fingerprint = fingerprint(point, locator_);
        return result;
    }

    void tell() {
        progress_.seconds = std::chrono::duration<double>(WallClock::now() - start_).count();
        if (options_.progress) {
            options_.progress(progress_);
        }
    }

    const config::SweepDescription& sweep_;
    const config::Locator& locator_;
    PointWorkers& workers_;
    const SweepOptions& options_;
    std::filesystem::path csv_;
    observe::FolderLock lock_;
    SweepTable table_;
    std::deque<std::size_t> missing_;
    std::map<std::size_t, int> losses_;
    SweepProgress progress_;
    WallClock::time_point start_ = WallClock::now();
};

}  // namespace

double SweepProgress::seconds_left() const {
    const std::size_t now = done - before;
    return now == 0 ? 0 : seconds / static_cast<double>(now) * static_cast<double>(points - done);
}

PointTask sweep_task(const config::SweepDescription& sweep, const config::Locator& locator) {
    return [&sweep, &locator](std::size_t point) {
        return observe::encode(run_point(sweep.point(point), locator));
    };
}

SweepProgress run_sweep(const config::SweepDescription& sweep, const config::Locator& locator,
                        PointWorkers& workers, const SweepOptions& options) {
    return SweepRun(sweep, locator, workers, options).run();
}

}  // namespace rasterloom::emulation
