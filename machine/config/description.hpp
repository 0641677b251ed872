// SPDX-License-Identifier: MIT
// A machine as its YAML file describes it: plain values, checked and with defaults filled in.
// Nothing here is built yet.
#pragma once

#include "machine/config/error.hpp"
#include "machine/config/units.hpp"
#include "machine/fabric/tile_assignment.hpp"
#include "machine/host/polygon_order.hpp"
#include "machine/host/tile_overlap.hpp"
#include "machine/kernel/time.hpp"
#include "machine/node/message_ports.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace rasterloom::config {

// A file that the configuration names: as written, and where it was found.
struct FileReference {
    std::string text;
    std::filesystem::path path;  // absolute
};

struct TopologyDescription {
    std::string kind;
    // Everything beside `kind`: checked by the topology itself. Values of file parameters are
    // absolute paths.
    std::map<std::string, std::string> parameters;
};

struct CostDescription {
    std::string model;                              // empty: the ISA's first
    std::map<std::string, std::int64_t> overrides;  // cycles; checked by the ISA
};

struct NodeDescription {
    std::string isa = "pdp11";
    std::optional<FileReference> plugin;  // a shared object that supplies the ISA
    ClockRate clock{Duration::microseconds(5), 0};
    CostDescription cost;
    std::int64_t memory = 56 * 1024;               // bytes
    FileReference program;                         // .s: assembled; .bin: raw image; .out: a.out
    std::map<std::string, std::int64_t> symbols;   // set before the program's first line
    std::uint32_t load_address = 0;                // raw images only
    std::optional<std::uint32_t> entry;            // default: what the program says
    std::optional<std::int64_t> phases_per_frame;  // default: the program's phases_per_frame
    bool pack = true;  // of an ISA with wide words: the assembler packs straight-line code
};

// Of a lock-step machine: its nodes are lanes of one array.
struct ArrayDescription {
    bool line_locked = true;
    std::int64_t line = 910;           // cycles of a scanline
    std::int64_t lines = 525;          // scanlines of a picture
    std::int64_t visible_lines = 512;  // the first of them
};

struct LinkDescription {
    Duration time_per_byte = Duration::microseconds(5);
    Duration time_per_message;
    Duration latency = Duration::microseconds(1);
    std::int64_t input_queue = 4;    // messages
    std::int64_t output_queue = 2;   // messages
    std::int64_t max_message = 256;  // bytes
    SendPolicy send = SendPolicy::one_at_a_time;
};

// Between the host and the processors of a machine that deals out the screen.
struct SplitterDescription {
    Duration time_per_vertex = Duration::nanoseconds(600);  // two memory cycles
    std::int64_t input_fifo = 4;                            // polygons
    std::int64_t output_fifo = 4;                           // polygons, of either output
};

struct PolygonBusDescription {
    Duration time_per_word = Duration::nanoseconds(300);
    std::int64_t input_fifo = 4;  // polygons
};

enum class FrameBufferKind : std::uint8_t {
    local,  // every processor has its own pixels, as in the thesis
    bus,    // every pixel written goes over one bus
};

struct FabricDescription {
    bool ideal = false;  // no time anywhere, no FIFO ever full: the thesis' assumption
    SplitterDescription splitter;
    PolygonBusDescription bus;
    std::int64_t processor_fifo = 4;  // polygons
    FrameBufferKind frame_buffer = FrameBufferKind::local;
    Duration frame_buffer_time_per_pixel = Duration::nanoseconds(300);
    Duration latency = Duration::microseconds(1);  // of every wire
    bool half_digested = false;
    std::int64_t digest_fifo = 2;  // polygons that wait at a processor for the bus of digests
};

// The computer that sends the polygons.
struct HostDescription {
    Duration time_per_polygon = Duration::microseconds(10);
    Duration time_per_vertex;
    host::PolygonOrder order = host::PolygonOrder::mesh;
    std::int64_t seed = 1;  // of shuffled
};

// What a tile counts for where rasterizers take the largest first.
enum class TileMeasure : std::uint8_t {
    triangles,  // all that a sorter by bounding box knows
    pixels,     // those to be drawn in it
    work,       // its time on a hardware rasterizer, the pipeline kept full
};

// Between the host and the rasterizers of a bucket tiler.
struct SorterDescription {
    host::OverlapRule rule = host::OverlapRule::bounding_box;
    TileAssignment assignment = TileAssignment::interleaved;
    TileMeasure largest_by = TileMeasure::triangles;
    Duration time_per_triangle;
    Duration time_per_pair;
    Duration time_per_word;  // to a software rasterizer
};

enum class RasterizerKind : std::uint8_t {
    hardware,  // a triangle unit and a pixel unit in a pipeline
    software,  // a processor of nodes.* that runs nodes.program
};

struct RasterizerDescription {
    RasterizerKind kind = RasterizerKind::hardware;
    std::int64_t cycles_per_triangle = 25;  // hardware, as the next two
    std::int64_t cycles_per_pixel = 1;
    std::optional<std::int64_t> fifo = 1;  // triangles between the units; none: unlimited
    std::int64_t input_fifo = 4;           // messages that wait at a software rasterizer
};

struct SupervisorDescription {
    Duration latency = Duration::microseconds(5);
};

struct ScreenDescription {
    std::int64_t width = 256;  // pixels
    std::int64_t height = 256;
    std::optional<FileReference> map;  // columns of an array's lanes; none: lane i has column i
};

enum class Routing : std::uint8_t { small_circle, great_circle };
enum class Normals : std::uint8_t { smooth, face };

struct RotationDescription {
    glm::dvec3 axis{0, 0, 1};  // world axes of machine/host/view.hpp
    double degrees = 0;        // from each frame to the next
    double start = 0;          // degrees, of the first frame; the object is handed out unrotated
};

struct TextureDescription {
    std::string name = "none";                  // or a built-in pattern ...
    std::optional<std::filesystem::path> file;  // ... or a picture
};

// Where the viewer of bucket tiles stands, in place of scene.scale, translate and
// vanishing_distance.
struct CameraDescription {
    std::optional<glm::dvec3> eye;  // none: the view's
    glm::dvec3 target{0, 0, 0};
    double field_of_view = 40;  // degrees between the screen's left and right side
};

// Of random screen triangles (machine/host/triangle_scenes.hpp).
struct RandomTrianglesDescription {
    std::int64_t count = 1000;
    double mean_area = 100;       // pixels
    double depth_complexity = 0;  // in its place: all areas over the screen's; 0: mean_area holds
    std::int64_t skew = 0;
    double box_ratio = 3;
    double aspect = 1;
};

struct SceneDescription {
    std::string object = "teapot";              // a built-in object or polygon scene ...
    std::optional<std::filesystem::path> mesh;  // ... or a mesh, polygon or triangle file
    std::optional<FileReference> model;         // in place of a polygon scene's own
    TextureDescription texture;                 // of a scene on a lock-step machine or bucket tiles
    std::int64_t polygons = 500;                // of a random scene
    RandomTrianglesDescription triangles;       // of random-triangles
    std::int64_t seed = 1;                      // likewise
    std::string up = "y";                       // axis of the mesh that points up
    std::string front = "z";                    // axis of the mesh that faces the viewer
    double size = 0.98;                         // radius to which a mesh file is fitted
    Normals normals = Normals::smooth;
    RotationDescription rotate;
    Routing routing = Routing::small_circle;
    double scale = 0.9;
    glm::dvec3 translate{0, 0, 0};  // right, down, away
    double vanishing_distance = 4;
    CameraDescription camera;
    glm::dvec3 light{-0.7, 0.3, 0.65};
    double ambient = 0.15;
    std::optional<std::int64_t> background;  // grey level; none: 0, or the polygon scene's own
};

struct RunDescription {
    std::int64_t frames = 1;
    Duration max_time = Duration::seconds(10);  // of the machine, all frames together
    std::optional<std::int64_t> threads;        // of the host; none: as many as pay
};

struct MachineDescription {
    std::string machine;
    TopologyDescription topology;
    NodeDescription nodes;
    ArrayDescription array;            // of lock-step machines
    LinkDescription links;             // of machines that are graphs
    FabricDescription fabric;          // of machines that deal out the screen
    HostDescription host;              // likewise
    SorterDescription sorter;          // of bucket tilers
    RasterizerDescription rasterizer;  // likewise
    SupervisorDescription supervisor;
    ScreenDescription screen;
    std::optional<SceneDescription>
        scene;  // none: the program runs on its own, no object and no picture
    RunDescription run;

    // Where each value was written; defaults are missing. Lets later steps (a program that does not
    // assemble, a cost parameter the ISA does not know) point at the line.
    std::map<std::string, Position, std::less<>> written;

    // Whether its nodes are rasterizers of triangles that a tile sorter hands out.
    bool is_bucket_tiler() const { return topology.kind == "bucket_tiles"; }
    // Whether its nodes run a program.
    bool has_program() const {
        return !is_bucket_tiler() || rasterizer.kind == RasterizerKind::software;
    }

    // An error about the value of `key`; points at the file when the value is a default.
    ConfigError error(const std::string& key, const std::string& value, const std::string& what,
                      const std::string& expected = {}, const std::string& nearest = {}) const;
    std::string source;  // the file
};

}  // namespace rasterloom::config
