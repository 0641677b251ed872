# SPDX-License-Identifier: MIT
"""Chen's figure 6: statistics of the scenes and the tiles that their triangles overlap, beside the formula of Molnar and Eyles."""

from chen_machine import save
from chen_scenes import PUBLISHED, TILES, meshes, overlap_factor, overlaps, synthetics
from measuring import table


def statistics(emulator, scenes):
    rows = []
    for name, scene in scenes.items():
        found, published = overlaps(emulator, scene), PUBLISHED.get(name)
        rows.append([name, found["visible"], f"{found['mean_area']:.1f}", published.area if published else "-", f"{found['depth_complexity']:.2f}",
                     published.complexity if published else "-", f"{found['box_ratio']:.2f}"])
    table(["scene", "visible triangles", "pixels a triangle", "published", "depth complexity", "published", "box over triangle"], rows)


def factors(emulator, scenes):
    rows = []
    for name, scene in scenes.items():
        found = overlaps(emulator, scene)
        for text, value in (("bounding box", lambda S: overlap_factor(emulator, scene, S)), ("exact", lambda S: overlap_factor(emulator, scene, S, "exact")),
                            ("covered", lambda S: overlap_factor(emulator, scene, S, "covered")),
                            ("Molnar-Eyles", lambda S: found["sizes"][S]["molnar_eyles"])):
            published = PUBLISHED[name].overlap if name in PUBLISHED and text == "bounding box" else None
            rows.append([name, text, *(f"{value(S):.2f}" for S in TILES), published or "-"])
    table(["scene", "overlap", *(f"{S} x {S}" for S in TILES), "published, 8 x 8"], rows)


def overlap(emulator, arguments):
    for title, kind, scenes in (("Synthetic scenes with the paper's statistics", "synthetic", synthetics()),
                                ("Meshes", "meshes", meshes(arguments.models))):
        print(f"### {title}\n")
        statistics(emulator, scenes)
        factors(emulator, scenes)

        def draw(axes):
            for i, (name, scene) in enumerate(scenes.items()):
                axes.loglog(TILES, [overlap_factor(emulator, scene, S) for S in TILES], "o-", color=f"C{i}", label=name)
                axes.loglog(TILES, [overlap_factor(emulator, scene, S, "exact") for S in TILES], ":", color=f"C{i}")
                if name in PUBLISHED and PUBLISHED[name].overlap:
                    axes.plot([8], [PUBLISHED[name].overlap], "k*", markersize=9)
            axes.plot([], [], "k:", label="exact")

        save(arguments, f"6-{kind}", draw, f"Chen 1998, figure 6: tiles a triangle, {kind}", "side of a tile, pixels", "overlap factor")
