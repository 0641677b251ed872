# SPDX-License-Identifier: MIT
"""A frame of each model where the sort stands elsewhere on the emulated Princeton Engine."""

from measuring import EmulatorError, table
from princeton_machine import CROWDED, changes_of, is_crowded, machine_scenes, symbols

SCHEMES = {"sort-middle": ("sort-middle", {}), "sort-middle, d = 16": ("sort-middle", {"stride": 16}), "sort-twice, g = 64": ("sort-twice", {}),
           "sort-last, sparse": ("sort-last-sparse", {}), "sort-last, dense": ("sort-last-dense", {})}
STAGES = {"geometry": "geometry", "communicate": "communication", "normalise": "normalising", "rasterise": "rasterising",
          "composite": "bringing pixels together"}


def frame(emulator, config, scene, **options):
    """Cycles by stage, and all of them; None where there is no room for all descriptors."""
    changes = (*scene, ("array.line_locked", "false"), *(symbols(**options) if options else ()))
    try:
        found = emulator.run(f"princeton1024-{config}", *changes_of(changes), "--check-communication")[0]["array"]
    except EmulatorError as error:
        if is_crowded(error):
            return None
        raise
    return {**{part["name"]: part["cycles_u"] for part in found["phases"]}, "all": found["cycles_u"]}


def cells(found):
    if found is None:
        return [CROWDED]
    return [f"{found['all'] / 14e3:.1f} ms", f"{14e6 / found['all']:.1f}", *(f"{found[stage]:,}" if stage in found else "" for stage in STAGES)]


def schemes(emulator, arguments):
    """Not line-locked, shaded, the first frame; sort-twice with deferred shading."""
    table(["model", "scheme", "frame", "frames/s", *STAGES.values()],
          [[name, scheme, *cells(frame(emulator, config, scene, **options))]
           for name, scene in machine_scenes(arguments).items() for scheme, (config, options) in SCHEMES.items()])
