// SPDX-License-Identifier: MIT
#include "machine/observe/trace/tree_builder.hpp"

#include <array>
#include <stdexcept>
#include <utility>

namespace rasterloom::observe {

namespace {

constexpr std::size_t kChild = 4;  // bytes of a page's number

std::array<std::uint8_t, kChild> number_of(std::uint32_t page) {
    std::array<std::uint8_t, kChild> bytes{};
    put_big_endian(bytes.data(), page, kChild);
    return bytes;
}

std::uint32_t page_of(Bytes number) {
    return std::uint32_t{number[0]} << 24U | std::uint32_t{number[1]} << 16U |
           std::uint32_t{number[2]} << 8U | std::uint32_t{number[3]};
}

}  // namespace

TreeBuilder::TreeBuilder(PageFile& file, std::uint32_t root, Kind kind)
    : file_(file), root_(root), kind_(kind) {
    level(0);
}

TreeBuilder::Level& TreeBuilder::level(std::size_t number) {
    if (number == levels_.size()) {
        using Page = TreePage::Kind;
        const Page leaf = kind_ == Kind::table ? Page::leaf_table : Page::leaf_index;
        const Page inner = kind_ == Kind::table ? Page::inner_table : Page::inner_index;
        levels_.push_back({TreePage(number == 0 ? leaf : inner, file_.page_size()), std::nullopt});
    }
    return levels_[number];
}

void TreeBuilder::add(std::int64_t rowid, Bytes record) {
    std::array<std::uint8_t, 2 * kMostVarint> sizes;
    std::size_t size = put_varint(sizes.data(), record.size());
    size += put_varint(sizes.data() + size, static_cast<std::uint64_t>(rowid));
    if (record.size() > file_.page_size() / 4) {
        throw std::length_error("a row is too long to be added to a table");
    }
    TreePage& leaf = levels_[0].page;
    if (!leaf.has_room_for(size + record.size())) {
        const std::uint32_t number = file_.append(leaf.finished());
        leaf.clear();
        std::array<std::uint8_t, kMostVarint> key;
        add_child(1, number,
                  {key.data(), put_varint(key.data(), static_cast<std::uint64_t>(last_rowid_))});
    }
    leaf.add({sizes.data(), size}, record);
    last_rowid_ = rowid;
}

void TreeBuilder::add(Bytes record) {
    if (record.size() > file_.page_size() / 8) {
        throw std::length_error("a row is too long to be added to an index");
    }
    std::array<std::uint8_t, kMostVarint> size;
    add_cell(0, {size.data(), put_varint(size.data(), record.size())}, record);
}

// The key that finds no room on a page goes up, between that page and the next.
void TreeBuilder::add_cell(std::size_t number, Bytes first, Bytes key) {
    Level& here = level(number);
    if (here.page.has_room_for(first.size() + key.size())) {
        here.page.add(first, key);
        if (here.full) {
            settle(number);
        }
        return;
    }
    Key between;
    if (here.page.is_inner()) {
        here.page.set_last_child(page_of(first));
    } else {
        between.assign(first.begin(), first.end());
    }
    between.insert(between.end(), key.begin(), key.end());
    here.full.emplace(Full{here.page, std::move(between)});
    here.page.clear();
}

void TreeBuilder::add_child(std::size_t number, std::uint32_t child, Bytes key) {
    add_cell(number, number_of(child), key);
}

void TreeBuilder::settle(std::size_t number) {
    Full full = std::move(*levels_[number].full);
    levels_[number].full.reset();
    add_child(number + 1, file_.append(full.page.finished()), full.key);
}

// The last cell of the full page goes up in place of the key that waits, which goes down.
void TreeBuilder::fill_last_page(Level& last) {
    Full& full = *last.full;
    Key cell = full.page.pop();
    if (!last.page.is_inner()) {
        last.page.add({}, full.key);
        full.key = std::move(cell);
        return;
    }
    last.page.add(number_of(full.page.last_child()), full.key);
    full.page.set_last_child(page_of(cell));
    full.key.assign(cell.begin() + kChild, cell.end());
}

void TreeBuilder::finish() {
    std::uint32_t child = 0;
    for (std::size_t number = 0;; ++number) {
        Level& here = levels_[number];
        if (here.full) {
            fill_last_page(here);
            settle(number);
        }
        here.page.set_last_child(child);
        if (number + 1 == levels_.size()) {
            file_.replace(root_, here.page.finished());
            return;
        }
        child = file_.append(here.page.finished());
    }
}

}  // namespace rasterloom::observe
