// SPDX-License-Identifier: MIT
// Records and pages of b-trees as SQLite's files hold them
// (https://www.sqlite.org/fileformat2.html, sections 1.6 and 2.1).
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace rasterloom::observe {

using Bytes = std::span<const std::uint8_t>;

// In place of a number: NULL.
inline constexpr std::int64_t kSqlNull = std::numeric_limits<std::int64_t>::min();

inline constexpr std::size_t kMostVarint = 9;  // bytes

// Writes the number as SQLite's varint, highest bits first; returns how many bytes it takes.
inline std::size_t put_varint(std::uint8_t* to, std::uint64_t value) {
    if (value < 0x80) {
        *to = static_cast<std::uint8_t>(value);
        return 1;
    }
    if (value >> 56U != 0) {  // the ninth byte has no flag
        to[8] = static_cast<std::uint8_t>(value);
        value >>= 8U;
        for (std::size_t i = 8; i-- > 0; value >>= 7U) {
            to[i] = static_cast<std::uint8_t>(value | 0x80U);
        }
        return 9;
    }
    const auto size = static_cast<std::size_t>(std::bit_width(value) + 6) / 7;
    for (std::size_t i = size; i-- > 0; value >>= 7U) {
        to[i] = static_cast<std::uint8_t>(value | 0x80U);
    }
    to[size - 1] &= 0x7fU;
    return size;
}

inline void put_big_endian(std::uint8_t* to, std::uint64_t value, std::size_t bytes) {
    for (std::size_t i = bytes; i-- > 0; value >>= 8U) {
        to[i] = static_cast<std::uint8_t>(value);
    }
}

// Values one after the other, as a row holds them.
class SqliteRecord {
  public:
    static constexpr std::size_t kMostValues = 32;

    explicit SqliteRecord(std::size_t values) : header_(values + 1) {
        start_[0] = static_cast<std::uint8_t>(header_);
        end_ = header_;
    }
    void add(std::int64_t value) {
        if (value == kSqlNull) {
            start_[next_++] = 0;
            return;
        }
        if (value == 0 || value == 1) {  // takes no room but its type
            start_[next_++] = static_cast<std::uint8_t>(8 + value);
            return;
        }
        const auto bits = static_cast<std::size_t>(
            std::bit_width(static_cast<std::uint64_t>(value < 0 ? ~value : value)) + 1);
        const Class& by = kClasses[(bits + 7) / 8];
        start_[next_++] = by.type;
        // The eight bytes from the first one that counts; those behind it are written over.
        const std::uint64_t shifted = static_cast<std::uint64_t>(value) << (64U - 8U * by.bytes);
        const std::uint64_t ordered =
            std::endian::native == std::endian::little ? __builtin_bswap64(shifted) : shifted;
        std::memcpy(start_ + end_, &ordered, sizeof ordered);
        end_ += by.bytes;
    }
    Bytes bytes() const { return {start_, end_}; }

  private:
    struct Class {
        std::uint8_t type;
        std::uint8_t bytes;
    };
    static constexpr Class kClasses[] = {{1, 1}, {1, 1}, {2, 2}, {3, 3}, {4, 4},
                                         {5, 6}, {5, 6}, {6, 8}, {6, 8}};

    std::uint8_t start_[1 + kMostValues + 8 * kMostValues + 8];
    std::size_t header_;
    std::size_t next_ = 1;
    std::size_t end_ = 0;
};

// One page of a b-tree, filled in the order of its keys. Inner pages also name the page of what
// comes after their last cell.
class TreePage {
  public:
    enum class Kind : std::uint8_t {
        inner_index = 2,
        inner_table = 5,
        leaf_index = 10,
        leaf_table = 13,
    };

    TreePage(Kind kind, std::size_t size) : kind_(kind), bytes_(size), content_(size) {
        last_end_ = size;
    }

    bool is_inner() const { return kind_ == Kind::inner_index || kind_ == Kind::inner_table; }
    bool is_empty() const { return cells_ == 0; }
    bool has_room_for(std::size_t cell) const {
        return header() + 2 * (cells_ + 1) + cell <= content_;
    }
    // A cell, in two parts.
    void add(Bytes first, Bytes second) {
        last_end_ = content_;
        content_ -= first.size() + second.size();
        std::copy(first.begin(), first.end(),
                  bytes_.begin() + static_cast<std::ptrdiff_t>(content_));
        std::copy(second.begin(), second.end(),
                  bytes_.begin() + static_cast<std::ptrdiff_t>(content_ + first.size()));
        put_big_endian(bytes_.data() + header() + 2 * cells_++, content_, 2);
    }
    // Takes away what was added last, once.
    std::vector<std::uint8_t> pop() {
        std::vector<std::uint8_t> cell(bytes_.begin() + static_cast<std::ptrdiff_t>(content_),
                                       bytes_.begin() + static_cast<std::ptrdiff_t>(last_end_));
        content_ = last_end_;
        --cells_;
        return cell;
    }
    void set_last_child(std::uint32_t page) { last_child_ = page; }
    std::uint32_t last_child() const { return last_child_; }
    void clear() {
        content_ = last_end_ = bytes_.size();
        cells_ = 0;
    }

    // As the file holds it.
    Bytes finished() {
        std::uint8_t* to = bytes_.data();
        to[0] = static_cast<std::uint8_t>(kind_);
        put_big_endian(to + 1, 0, 2);  // no free blocks
        put_big_endian(to + 3, cells_, 2);
        put_big_endian(to + 5, content_, 2);  // 65536 is 0
        to[7] = 0;                            // no fragments
        if (is_inner()) {
            put_big_endian(to + 8, last_child_, 4);
        }
        std::fill(to + header() + 2 * cells_, to + content_, std::uint8_t{0});
        return bytes_;
    }

  private:
    std::size_t header() const { return is_inner() ? 12 : 8; }

    Kind kind_;
    std::vector<std::uint8_t> bytes_;
    std::size_t cells_ = 0;
    std::size_t content_;  // where it begins; it ends with the page
    std::size_t last_end_ = 0;
    std::uint32_t last_child_ = 0;
};

}  // namespace rasterloom::observe
