// SPDX-License-Identifier: MIT
// The host's part for programs/pdp11/strothotte.s: object initialisation on the host, one facet to
// each processor, and the picture out of the processors' pixel memories.
#include "machine/emulation/job.hpp"
#include "machine/emulation/object.hpp"
#include "machine/emulation/strothotte_collector.hpp"
#include "machine/emulation/strothotte_loader.hpp"
#include "machine/host/facets.hpp"
#include "machine/host/projection.hpp"
#include "machine/host/renderer.hpp"
#include "topologies/screen_map.hpp"

#include <stdexcept>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

using config::MachineDescription;
using topology::Topology;

class StrothotteJob final : public HostJob {
  public:
    explicit StrothotteJob(const Blueprint& blueprint)
        : description_(blueprint.description),
          rotation_(description_.scene->rotate),
          topology_(blueprint.topology),
          image_(*blueprint.image),
          view_(make_view(description_)),
          screen_(topology::nearest_pixel_map(topology_, view_.width, view_.height)),
          facets_(sample(description_, topology_)),
          loader_(image_,
                  {topology_, screen_, facets_, static_cast<int>(description_.links.max_message),
                   static_cast<std::uint32_t>(description_.nodes.memory)},
                  {view_, rotation_.start, rotation_.degrees,
                   description_.scene->routing == config::Routing::great_circle}) {}

    void load(Machine& machine) override {
        const std::vector<Processor*>& processors = machine.processors();
        for (topology::NodeIndex node = 0; node < processors.size(); ++node) {
            for (const isa::Segment& segment : memory_of(node)) {
                processors[node]->core().write_memory(segment.address, segment.bytes);
            }
        }
    }

    host::Picture collect(const Machine& machine) const override {
        const std::vector<Processor*>& processors = machine.processors();
        host::Picture picture(view_.width, view_.height, 1,
                              static_cast<std::uint8_t>(view_.background));
        for (topology::NodeIndex node = 0; node < processors.size(); ++node) {
            collect_pixels(image_, screen_, node, processors[node]->core().memory(), picture);
        }
        return picture;
    }

    host::Picture reference(std::int64_t frame) const override {
        host::View view = view_;
        view.degrees = rotation_.start + static_cast<double>(frame) * rotation_.degrees;
        return host::reference_render(host::project(facets_, topology_, view), view);
    }

    int background() const override { return view_.background; }

    std::string remarks() const override {
        std::string text =
            fmt::format("Object          {} crossings on {} facets, {} triangles",
                        statistics_.crossings, facets_.crossings.size(), facets_.triangles.size());
        if (statistics_.links.dropped > 0) {
            text += fmt::format("; {} crossings beyond the eighth of a facet left out",
                                statistics_.links.dropped);
        }
        if (statistics_.links.unpaired > 0) {
            text += fmt::format("; {} crossings without a neighbour to link to",
                                statistics_.links.unpaired);
        }
        return text;
    }

  private:
    std::vector<isa::Segment> memory_of(topology::NodeIndex node) const {
        try {
            return loader_.memory_of(node);
        } catch (const std::invalid_argument& problem) {
            throw description_.error("nodes.program", {}, problem.what(),
                                     "a program that draws the scene, such as pdp11/strothotte.s");
        }
    }

    host::FacetModel sample(const MachineDescription& description, const Topology& topology) {
        host::FacetOptions options;
        options.normals = description.scene->normals == config::Normals::face
                              ? host::NormalStyle::face
                              : host::NormalStyle::smooth;
        const host::Mesh object = make_object(description);
        try {
            return host::sample_facets(topology, object, options, &statistics_);
        } catch (const std::invalid_argument& problem) {
            throw description.error("scene.object", {}, problem.what());
        }
    }

    const MachineDescription& description_;
    config::RotationDescription rotation_;
    const Topology& topology_;
    const isa::Image& image_;
    host::View view_;
    topology::ScreenMap screen_;
    host::FacetStatistics statistics_;  // before facets_, whose making fills it
    host::FacetModel facets_;
    StrothotteLoader loader_;
};

}  // namespace

std::unique_ptr<HostJob> make_strothotte_job(const Blueprint& blueprint) {
    return std::make_unique<StrothotteJob>(blueprint);
}

}  // namespace rasterloom::emulation
