// SPDX-License-Identifier: MIT
#include "programs/strothotte_run.hpp"

#include "isa/assembler.hpp"
#include "isa/pdp11/pdp11.hpp"
#include "machine/emulation/strothotte_collector.hpp"
#include "machine/emulation/strothotte_loader.hpp"
#include "machine/fabric/network.hpp"
#include "machine/host/facets.hpp"
#include "machine/host/renderer.hpp"
#include "machine/host/scenes.hpp"
#include "topologies/geodesic.hpp"

#include <fmt/format.h>
#include <glm/vec3.hpp>

namespace rasterloom::test {

namespace {

class FrameKeeper final : public SupervisorListener {
  public:
    FrameKeeper(const SampledObject& object, const host::View& view, StrothotteRun& run)
        : object_(object), view_(view), run_(run) {}
    std::vector<Processor*> processors;

    void phase_ended(const PhaseRecord& record) override { run_.phases.push_back(record); }
    void frame_ended(int, Time) override {
        host::Picture picture(view_.width, view_.height, 1,
                              static_cast<std::uint8_t>(view_.background));
        for (topology::NodeIndex n = 0; n < processors.size(); ++n) {
            collect_pixels(strothotte_image(), object_.screen, n, processors[n]->core().memory(),
                           picture);
        }
        run_.pictures.push_back(std::move(picture));
    }

  private:
    const SampledObject& object_;
    const host::View& view_;
    StrothotteRun& run_;
};

}  // namespace

const isa::Image& strothotte_image() {
    static const isa::Image image = isa::assemble_image(
        isa::pdp11::pdp11_isa(), RASTERLOOM_SOURCE_DIR "/programs/pdp11/strothotte.s");
    return image;
}

SampledObject sample_object(int b, int c, const std::string& object, const host::View& view,
                            double degrees) {
    SampledObject sampled;
    sampled.topology = topology::geodesic(b, c);
    sampled.screen = topology::nearest_pixel_map(sampled.topology, view.width, view.height);
    host::Mesh mesh = host::make_scene_object(object);
    host::View turned = view;
    turned.degrees = degrees;
    const glm::dmat3 rotation = host::rotation_of(turned);
    for (glm::dvec3& position : mesh.positions) {
        position = rotation * position;
    }
    for (glm::dvec3& normal : mesh.normals) {
        normal = rotation * normal;
    }
    sampled.facets = host::sample_facets(sampled.topology, mesh);
    return sampled;
}

StrothotteRun run_strothotte(const SampledObject& object, const StrothotteScene& scene,
                             const StrothotteOptions& options) {
    const isa::Isa& isa = isa::pdp11::pdp11_isa();
    const isa::Image& image = strothotte_image();
    const auto program = isa.prepare(image, isa::CostChoice{"strothotte", {}});
    const StrothotteLoader loader(
        image, {object.topology, object.screen, object.facets, 256, options.memory_bytes}, scene);
    const auto shared_image = std::make_shared<isa::Image>(image);
    StrothotteRun run;
    FrameKeeper keeper(object, scene.view, run);
    Simulation simulation;
    Supervisor::Settings settings;
    settings.phases_per_frame = strothotte_phases_per_frame(image);
    settings.frames = options.frames;
    settings.nodes = static_cast<int>(object.topology.nodes.size());
    auto& supervisor = simulation.add<Supervisor>("supervisor", settings);
    supervisor.probe().attach(keeper);
    for (topology::NodeIndex n = 0; n < object.topology.nodes.size(); ++n) {
        auto core = isa.make_core(program, {});
        for (const isa::Segment& segment : loader.memory_of(n)) {
            core->write_memory(segment.address, segment.bytes);
        }
        Processor::Settings s;
        s.node = n;
        s.ports.ports = static_cast<int>(object.topology.ports[n].size());
        s.ports.output_queue = options.output_queue;
        s.ports.input_queue = options.input_queue;
        s.image = shared_image;
        for (const auto& name : isa.register_names()) {
            s.register_names.emplace_back(name);
        }
        auto& processor =
            simulation.add<Processor>(fmt::format("node/{:05}", n), std::move(core), s);
        supervisor.connect(simulation, static_cast<int>(n), processor);
        keeper.processors.push_back(&processor);
    }
    LinkSettings link;
    link.time_per_byte = Duration::microseconds(1);
    link.input_queue = options.input_queue;
    connect_network(simulation, object.topology, keeper.processors, link);
    simulation.seal();
    const RunResult result = simulation.run(Time::zero() + Duration::seconds(100));
    if (result.failure) {
        run.failure = result.failure->message();
    } else if (result.end != RunEnd::finished || !supervisor.over()) {
        run.failure = "the run did not end";
    }
    for (Processor* processor : keeper.processors) {
        processor->close_books(result.time);
        run.nodes.push_back(processor->statistics());
        run.instructions += processor->core().instructions_retired();
        for (int k = 0; k < processor->message_ports().count(); ++k) {
            run.messages += processor->message_ports().statistics(k).messages_sent;
        }
    }
    return run;
}

host::Picture reference_picture(const SampledObject& object, const host::View& view,
                                double degrees) {
    host::View turned = view;
    turned.degrees = degrees;
    return host::reference_render(host::project(object.facets, object.topology, turned), turned);
}

}  // namespace rasterloom::test
