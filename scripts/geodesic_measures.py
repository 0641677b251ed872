# SPDX-License-Identifier: MIT
"""What is measured of the geodesic machine, as numbers: results.py prints tables of them, papers/strothotte1981.py compares them."""

import re
from collections import Counter

from measuring import setting

PHASES = ("rotate", "points", "assemble", "transfer", "draw")  # those that the thesis has a cost for
CONFIG = "configs/geodesic482.yaml"


def phase(statistics, name, frame=None):
    found = [p for p in statistics["phases"] if p["name"] == name and frame in (None, p["frame"])]
    return found[-1]


def graph_of(emulator, b, c):
    """Nodes, how many of each degree, edges, diameter, radius, mean distance, whether planar, pixels of a node."""
    described = emulator.text("describe", CONFIG, *setting(topology__b=b, topology__c=c))
    nodes = re.search(r"^Nodes +(\d+):? ?(.*)$", described, re.MULTILINE)
    distances = re.search(r"diameter (\d+), radius (\d+), mean ([0-9.]+)", described)
    pixels = re.search(r"(\d+) to (\d+) pixels a node, mean ([0-9.]+)", described)
    return {"nodes": int(nodes[1]), "degrees": {int(d): int(n) for n, d in re.findall(r"(\d+) of degree (\d+)", nodes[2])},
            "edges": int(re.search(r"^Edges +(\d+)", described, re.MULTILINE)[1]), "diameter": int(distances[1]), "radius": int(distances[2]),
            "mean": float(distances[3]), "planar": re.search(r"^Planar +(.*)$", described, re.MULTILINE)[1],
            "greatest_part": int(pixels[2]), "mean_part": float(pixels[3])}


def place_of(emulator, name):
    """phi and theta of a processor in degrees, and its neighbours' names."""
    described = emulator.text("describe", CONFIG, "--node", name)
    phi, theta = re.search(rf"{name} is node .*: phi ([0-9.]+), theta ([0-9.]+) degrees", described).groups()
    return float(phi), float(theta), re.findall(r"port \d+ to (P\d+-\d+)", described)


def rounds_of(emulator, routing, part, **settings):
    """Of a phase in synchronous rounds: longest route in hops, rounds, share of the processors that send in each, hops of every message, the
    busiest sender and how many messages it sends."""
    records = {}
    statistics, _ = emulator.run("geodesic482-rounds", *setting(**settings), *setting(scene__routing=routing), records=records)
    found = phase(statistics, part)
    sent = [row for row in records["messages"] if row["kind"] == ("1" if part == "rotate" else "5")]
    busiest, messages = Counter(int(row["source"]) for row in sent).most_common(1)[0]
    return {"longest": found["longest_route_hops"], "rounds": found["synchronous"]["rounds"],
            "utilisation": found["synchronous"]["utilisation"], "routes": routes(sent),
            "busiest": records["nodes"][busiest]["name"], "busiest_messages": messages}


def routes(sent):
    """How many messages went how many hops: each is known by its last one."""
    hops = {}
    for row in sent:
        hops[row["id"]] = max(hops.get(row["id"], 0), int(row["hops"]) + 1)
    return Counter(hops.values())


def rotation(emulator, degrees, routing="small_circle"):
    return rounds_of(emulator, routing, "rotate", scene__object="sphere", scene__rotate__start=degrees)


def drawing(emulator, name, routing="small_circle", **settings):
    return rounds_of(emulator, routing, "transfer", scene__object=name, **settings)


def frame_of(emulator, name="sphere", scale=0.8, move=0, u="5us", b=4, c=4):
    """The second frame of a rotation by 6 degrees, m = 1 u a byte: u of each phase, of the frame, and its picoseconds. A sphere of scale 0.8
    covers half of the screen: the example of the thesis. `move` counts moves and branches."""
    statistics, _ = emulator.run(
        "geodesic482", "--frames", "2",
        *setting(topology__b=b, topology__c=c, scene__object=name, scene__scale=scale, scene__rotate__degrees=6, nodes__clock=u,
                 links__time_per_byte=u, supervisor__latency=u, nodes__cost__move=move, nodes__cost__branch=move))
    second = statistics["frames"][-1]
    return {**{part: phase(statistics, part, frame=1)["duration_u"] for part in PHASES},
            "frame": second["duration_u"], "picoseconds": second["duration_ps"]}


def compared(summary):
    """Shares and greatest difference of the last frame."""
    return re.findall(r"^Frame \d+ +([0-9.]+) % of all pixels and ([0-9.]+) % of .*; greatest difference (\d+)$", summary,
                      re.MULTILINE)[-1]


def agreement(emulator, *arguments):
    """Per cent of the pixels within two grey levels of the reference renderer's."""
    return float(compared(emulator.run("geodesic482", "--compare", *arguments)[1])[0])
