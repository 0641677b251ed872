# SPDX-License-Identifier: MIT
"""What limits a machine: the part of it that is longest on the critical paths of its frames (docs/bottlenecks.md)."""

HALF = 0.5
COMMUNICATION = ("communicate", "migrate", "composite")  # phases of a lock-step machine, which is one sequencer's path
SHOWN = 3  # names


def part_of(component):
    """What a step of the path is an example of, and its name."""
    kind, name = component["kind"], component["name"]
    if kind == "node":
        return "processors", name
    if kind == "link":
        return "links", name
    if kind == "host":
        return "host", ""
    if kind == "wire":
        return "waiting", ""
    return kind, f"{kind} {name}"


def shares(path):
    """Of one frame's time: what is on the path, by part, and by part and name."""
    parts, names = {}, {}
    for component in path["components"]:
        part, name = part_of(component)
        share = component["time_ps"] / path["duration_ps"]
        parts[part] = parts.get(part, 0) + share
        names[part, name] = names.get((part, name), 0) + share
    return parts, names


def on_nodes(path):
    return sum(kind["time_ps"] for kind in path["kinds"] if kind["kind"] == "node") / path["duration_ps"]


def longest(frames, part):
    """Of each frame the longest of a part on the path: names, without repetition, and the mean share."""
    found = [max(((share, name) for (of, name), share in names.items() if of == part), default=(0, "")) for _, names in frames]
    return list(dict.fromkeys(name for share, name in found if share)), sum(share for share, _ in found) / len(found)


def phase_shares(path):
    found = {}
    for phase in path["phases"]:
        found[phase["name"]] = found.get(phase["name"], 0) + phase["time_ps"] / path["duration_ps"]
    return found


def limit_of_array(statistics):
    """Lanes work in step: all of the path is the sequencer's, and its phases tell where the time goes."""
    paths = [phase_shares(path) for path in statistics["critical_paths"]]
    mean = {name: sum(shares.get(name, 0) for shares in paths) / len(paths) for name in sorted({name for shares in paths for name in shares})}
    longest = max(mean, key=mean.get)
    return f"sequencer, longest in {longest} ({100 * mean[longest]:.0f} %)", sum(mean.get(name, 0) for name in COMMUNICATION)


def limit_of(statistics, nodes):
    """In words; and the share of communication, everything on the paths that is no processor."""
    if "array" in statistics:
        return limit_of_array(statistics)
    frames = [shares(path) for path in statistics["critical_paths"]]
    parts = {}
    for of_frame, _ in frames:
        for part, share in of_frame.items():
            parts[part] = parts.get(part, 0) + share / len(frames)
    part = max(parts, key=parts.get)
    names, share = longest(frames, part)
    communication = 1 - sum(map(on_nodes, statistics["critical_paths"])) / len(frames)
    if part == "processors":
        return processor_limit(names, share, nodes) + unit_limit(statistics), communication
    what = {"links": "links", "host": "host", "waiting": "waiting: latency of wires"}.get(part, " ".join(names[:1]))
    return f"{what} ({100 * parts[part]:.0f} %)", communication


def unit_limit(statistics):
    """What a rasterizer in hardware is busy with: one unit while the other waits."""
    if statistics.get("buckets", {}).get("rasterizer") != "hardware":
        return ""
    times = {}
    for path in statistics["critical_paths"]:
        for activity in path["activities"]:
            times[activity["name"]] = times.get(activity["name"], 0) + activity["time_ps"]
    return "".join(f"; {name} {100 * time / sum(times.values()):.0f} %" for name, time in times.items())


def processor_limit(names, share, nodes):
    busiest = max(nodes, key=lambda node: int(node["busy_ps"]))["name"]
    shown = f"{', '.join(names[:SHOWN])}{', ...' if len(names) > SHOWN else ''}"
    if len(nodes) == 1:
        return f"the processor ({100 * share:.0f} %)"
    if share < HALF:
        return f"processors by turns, {shown} the longest ({100 * share:.0f} %)"
    if len(names) > 1:
        return f"one processor a frame, {shown} ({100 * share:.0f} %)"
    return f"{'the busiest processor' if names == [busiest] else 'a processor that others wait for'}, {shown} ({100 * share:.0f} %)"
