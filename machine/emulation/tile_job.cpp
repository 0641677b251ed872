// SPDX-License-Identifier: MIT
// The host's part for programs/pdp11/tiler.s: which pixels are whose, polygons from the scene, and
// the picture out of the processors' frame buffers.
#include "machine/emulation/job.hpp"
#include "machine/emulation/polygon_frames.hpp"
#include "machine/emulation/tiler_loader.hpp"
#include "machine/host/polygon_renderer.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

using config::MachineDescription;
using topology::PixelGrid;

class TileJob final : public HostJob {
  public:
    explicit TileJob(const Blueprint& blueprint)
        : description_(blueprint.description),
          distribution_(*blueprint.distribution),
          image_(*blueprint.image),
          scene_(make_polygon_frames(description_)) {}

    void load(Machine& machine) override {
        const std::vector<Processor*>& processors = machine.processors();
        const TilerScreen screen{distribution_.width, distribution_.height, scene_.background};
        try {
            for (std::size_t node = 0; node < processors.size(); ++node) {
                load_tiler(processors[node]->core(), image_, distribution_.grids[node], screen);
            }
        } catch (const std::invalid_argument& problem) {
            throw description_.error("nodes.program", {}, problem.what(),
                                     "a program that draws polygons, such as pdp11/tiler.s");
        }
    }

    HostFrames frames() const override { return {scene_.frames, {}}; }

    host::Picture collect(const Machine& machine) const override {
        const std::vector<Processor*>& processors = machine.processors();
        host::Picture picture(distribution_.width, distribution_.height);
        for (std::size_t node = 0; node < processors.size(); ++node) {
            collect_pixels(*processors[node]->frame_buffer(), distribution_.grids[node], picture);
        }
        return picture;
    }

    host::Picture reference(std::int64_t frame) const override {
        host::PolygonRenderOptions options;
        options.width = distribution_.width;
        options.height = distribution_.height;
        options.background = scene_.background;
        options.precision = image_.symbol("full").value_or(1) != 0 ? host::Precision::full
                                                                   : host::Precision::thesis;
        return host::render_polygons(scene_.frames[static_cast<std::size_t>(frame)], options)
            .picture;
    }

    int background() const override { return scene_.background; }

    std::string remarks() const override {
        std::size_t polygons = 0;
        std::size_t vertices = 0;
        for (const std::vector<Polygon>& frame : scene_.frames) {
            polygons += frame.size();
            for (const Polygon& polygon : frame) {
                vertices += polygon.vertices.size();
            }
        }
        const std::size_t frames = scene_.frames.size();
        std::string text =
            fmt::format("Scene           {} polygons, {} vertices{}", polygons, vertices,
                        frames > 1 ? fmt::format(" in {} frames", frames) : std::string());
        if (scene_.setup) {
            const host::PolygonSetupStatistics& s = *scene_.setup;
            text += fmt::format(
                "; of {} given {} faced away and {} lay outside, {} more came from dividing, {} "
                "were clipped, {} repaired after rounding, {} became lines and {} points",
                s.given, s.back_faces, s.outside, s.additional, s.clipped, s.repaired, s.lines,
                s.points);
        }
        return text;
    }

  private:
    // y counts upwards, a picture's rows downwards.
    void collect_pixels(const FrameBuffer& pixels, const PixelGrid& grid,
                        host::Picture& picture) const {
        for (int row = 0; row < grid.rows; ++row) {
            const int y = distribution_.height - 1 - (grid.y_start + row * grid.y_step);
            const std::span<const std::uint8_t> words = pixels.image_row(row);
            std::uint8_t* pixel = &picture.at(grid.x_start, y);
            for (std::size_t byte = 0; byte < words.size(); byte += 2) {
                const auto shade = static_cast<std::int16_t>(words[byte] | words[byte + 1] << 8U);
                *pixel = static_cast<std::uint8_t>(std::clamp(shade / kShadeUnit, 0, 255));
                pixel += byte + 2 < words.size() ? grid.x_step : 0;
            }
        }
    }

    const MachineDescription& description_;
    const topology::Distribution& distribution_;
    const isa::Image& image_;
    PolygonFrames scene_;
};

}  // namespace

std::unique_ptr<HostJob> make_tile_job(const Blueprint& blueprint) {
    return std::make_unique<TileJob>(blueprint);
}

}  // namespace rasterloom::emulation
