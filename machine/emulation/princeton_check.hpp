// SPDX-License-Identifier: MIT
// Eldridge's correctness checks (1995, appendix A.3) on the emulated machine: whether a
// communication has brought every polygon to every lane that needs it, to no other, and to none
// twice. Who needs it follows from the box that geometry has found for it on its lane and from the
// screen map (machine/host/destinations.hpp); what a lane has got is read out of its memory. A
// polygon is known by its words: equal ones are as good as each other.
//
// After migration (sort-first) every polygon must be at home on exactly one lane, and a visible one
// on that of its left column. Where a lane may have had no room for all who come, others are
// allowed.
#pragma once

#include "machine/emulation/princeton_records.hpp"
#include "machine/emulation/princeton_screen.hpp"
#include "machine/host/delivery_check.hpp"
#include "topologies/region_map.hpp"

#include <string>
#include <unordered_map>
#include <vector>

namespace rasterloom {

class CommunicationCheck {
  public:
    // The image must outlive it. Throws std::invalid_argument when it lacks a symbol, and for a map
    // that gives a column to no lane or to several.
    CommunicationCheck(const isa::Image& image, const ColumnMap& columns);

    // The program goes from one phase to another: to be called before it executes anything more.
    // What is wrong with the communication that has ended, or nothing.
    std::string phase_ended(const LockstepArray& array, int phase, int next);

  private:
    struct Polygon {
        host::BoundingBox box;
        std::int64_t lane = 0;  // on which it was before, the first of several copies
        std::size_t place = 0;  // there, from 0
    };

    void begin(const LockstepArray& array);
    void add(const PrincetonRecord& record, std::int64_t lane, std::size_t place);
    std::string end_distribution(const LockstepArray& array) const;
    std::vector<bool> possibly_full(const LockstepArray& array) const;
    std::string end_migration(const LockstepArray& array) const;
    host::PolygonIndex number(const std::u16string& words, std::size_t occurrence) const;
    std::string name(host::PolygonIndex number) const;
    std::string tell(const host::DeliveryReport& report, const char* communication,
                     const char* lacks) const;

    PrincetonRecords records_;
    int distribution_;  // phases
    int migration_;
    std::int64_t lanes_;
    std::int64_t apart_;  // from a lane to the one that has copies of the same polygons
    topology::RegionMap map_;
    std::vector<Polygon> polygons_;
    std::unordered_map<std::u16string, std::vector<host::PolygonIndex>> by_words_;
};

}  // namespace rasterloom
