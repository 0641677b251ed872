// SPDX-License-Identifier: MIT
// The host's part for bucket tilers: triangles from the scene, and the picture out of what the
// rasterizers draw.
#include "machine/emulation/bucket_canvas.hpp"
#include "machine/emulation/bucket_loader.hpp"
#include "machine/emulation/job.hpp"
#include "machine/emulation/triangle_frames.hpp"
#include "machine/host/overlap_census.hpp"
#include "machine/host/triangle_planes.hpp"
#include "machine/host/triangle_reference.hpp"

#include <optional>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace rasterloom::emulation {

namespace {

using config::MachineDescription;

class BucketJob final : public HostJob {
  public:
    explicit BucketJob(const Blueprint& blueprint)
        : description_(blueprint.description),
          tiles_(*blueprint.tiles),
          image_(*blueprint.image),
          scene_(make_triangle_frames(description_)) {
        if (scene_.texture) {
            texture_ = host::make_tile_texture(*scene_.texture);
        }
        check_triangles();
    }

    void load(Machine& machine) override {
        if (!description_.has_program()) {
            hardware_.emplace(scene_, tiles_, texture());
            for (Rasterizer* rasterizer : machine.buckets()->rasterizers) {
                rasterizer->probe().attach(*hardware_);
            }
            return;
        }
        try {
            software_.emplace(image_, tiles_.screen_width(), tiles_.screen_height(),
                              scene_.background);
            for (Processor* processor : machine.processors()) {
                processor->frame_buffer_probe().attach(*software_);
                load_bucket(processor->core(), image_, scene_.background, texture());
            }
        } catch (const std::invalid_argument& problem) {
            throw description_.error("nodes.program", {}, problem.what(),
                                     "a program that draws tiles, such as pdp11/bucket.s");
        }
    }

    HostFrames frames() const override { return {{}, scene_.frames}; }

    void frame_ended(Machine& /*machine*/, std::int64_t /*frame*/) override {
        if (hardware_) {
            picture_ = hardware_->canvas().picture();
            hardware_->begin_next_frame();
        } else {
            picture_ = software_->picture();
            software_->clear();
        }
    }

    host::Picture collect(const Machine& /*machine*/) const override { return picture_; }

    host::Picture reference(std::int64_t frame) const override {
        return host::reference_triangles(scene_.frames[static_cast<std::size_t>(frame)],
                                         tiles_.screen_width(), tiles_.screen_height(),
                                         scene_.background, texture());
    }

    int background() const override { return scene_.background; }

    std::string remarks() const override {
        const host::TriangleCensus census = host::count_triangles(
            scene_.frames.front(), tiles_.screen_width(), tiles_.screen_height());
        return fmt::format(
            "Scene           {} triangles, {} of them visible: {:.1f} pixels each, depth "
            "complexity {:.2f}",
            census.triangles, census.visible, census.mean_area(), census.depth_complexity());
    }

  private:
    const host::TileTexture* texture() const { return texture_ ? &*texture_ : nullptr; }

    void check_triangles() const {
        for (std::size_t frame = 0; frame < scene_.frames.size(); ++frame) {
            const auto& triangles = scene_.frames[frame];
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                if (visible_box(triangles[i], tiles_.screen_width(), tiles_.screen_height()) &&
                    !host::fits_planes(triangles[i])) {
                    throw description_.error(
                        "scene.object", description_.scene->object,
                        fmt::format("triangle {} of frame {} is too large", i + 1, frame),
                        fmt::format("vertices within {} pixels of the screen's corner, and of each "
                                    "other, each way",
                                    host::kFarthestPlaneVertex));
                }
            }
        }
    }

    const MachineDescription& description_;
    const topology::BucketTiles& tiles_;
    const isa::Image& image_;
    TriangleFrames scene_;
    std::optional<host::TileTexture> texture_;
    std::optional<HardwareCanvas> hardware_;
    std::optional<SoftwareCanvas> software_;
    host::Picture picture_;
};

}  // namespace

std::unique_ptr<HostJob> make_bucket_job(const Blueprint& blueprint) {
    return std::make_unique<BucketJob>(blueprint);
}

}  // namespace rasterloom::emulation
