// SPDX-License-Identifier: MIT
#include "machine/fabric/rasterizer_path.hpp"

#include <algorithm>

namespace rasterloom {

namespace {

// Backwards along the longest way.
class WayBack {
  public:
    WayBack(std::span<const DrawnPair> pairs, std::optional<std::size_t> places)
        : pairs_(pairs), places_(places) {}

    std::vector<LimitingUnit> walk(bool until_drawn) {
        if (until_drawn) {
            pair_ = pairs_.size() - 1;
            pixels_ = true;
        } else {
            from_handing_over(pairs_.size() - 1);
        }
        while (pair_) {
            if (pixels_) {
                from_drawing(*pair_);
            } else {
                from_set_up(*pair_);
            }
        }
        std::reverse(units_.begin(), units_.end());
        return std::move(units_);
    }

  private:
    // What lies before the first pair's set-up belongs to earlier grants: their pixels are drawn.
    void leave(Cycles at) {
        add(true, pairs_.front().begun, at);
        pair_.reset();
    }

    void from_handing_over(std::size_t pair) {
        const DrawnPair& p = pairs_[pair];
        pixels_ = p.handed_over > p.set_up;
        pair_ = pair;
        if (pixels_) {
            const std::size_t back = *places_;  // the FIFO was full
            if (back > pair) {
                leave(p.handed_over);
            } else {
                pair_ = pair - back;
            }
        }
    }

    void from_set_up(std::size_t pair) {
        add(false, pairs_[pair].begun, pairs_[pair].set_up);
        if (pair == 0) {
            pair_.reset();
        } else {
            from_handing_over(pair - 1);
        }
    }

    void from_drawing(std::size_t pair) {
        const DrawnPair& p = pairs_[pair];
        add(true, p.drawing, p.drawn);
        if (p.drawing == p.set_up) {
            pixels_ = false;
        } else if (pair == 0) {
            leave(p.drawing);
        } else {
            pair_ = pair - 1;
        }
    }

    void add(bool is_pixel_unit, Cycles from, Cycles to) {
        if (from == to) {
            return;
        }
        if (!units_.empty() && units_.back().is_pixel_unit == is_pixel_unit) {
            units_.back().from = from;
        } else {
            units_.push_back({is_pixel_unit, from, to});
        }
    }

    std::span<const DrawnPair> pairs_;
    std::optional<std::size_t> places_;
    std::optional<std::size_t> pair_;  // where the way has come from; none: it is at its beginning
    bool pixels_ = false;              // its drawing, or its set-up
    std::vector<LimitingUnit> units_;
};

}  // namespace

std::vector<LimitingUnit> limiting_units(std::span<const DrawnPair> pairs,
                                         std::optional<std::size_t> places, bool until_drawn) {
    return WayBack(pairs, places).walk(until_drawn);
}

}  // namespace rasterloom
