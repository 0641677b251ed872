# SPDX-License-Identifier: MIT
"""T. Strothotte, Fast Raster Graphics using Parallel Processing, M.Sc. thesis, Simon Fraser University, 1981: the geodesic machine."""

from math import pi, sqrt

import numpy

from claims import EXACT, Claim, Tolerance
from geodesic_measures import agreement, drawing, frame_of, graph_of, place_of, rotation, rounds_of
from measuring import setting

TITLE = "Strothotte 1981: the geodesic machine of 482 processors"
NOTES = [
    "`configs/geodesic482-rounds.yaml` for messages in synchronous rounds, `configs/geodesic482.yaml` for times. Times are of the second frame of a "
    "rotation by 6 degrees of a sphere that covers half of the screen, m = 1 u a byte, with moves and branches free as the thesis counts. "
    "What the thesis puts in is not listed: a screen of 256 x 256, 1 u an addition and 10 u a multiplication, u of 1 to 5 microseconds. "
    "Of appendix A, the properties of a LISP program, only the pixels are: ours is laid out otherwise."]

P = 482
CLOSE = Tolerance(percent=5)
ROUNDED = Tolerance(margin=0.5)
PLACE = Tolerance(margin=0.002)
NO_FIGURE = "A picture without numbers, overprinted on a line printer."

# What its equations give for the example: 482 processors, m = 1, two crossings, 6 degrees, half of the screen, 500 triangles.
CT = (48 + 16) * sqrt(P) / 2
CS = 9 * 65536 / P + (61 + 20) * (362 / P) * sqrt(500 / 0.5) + 257 * 500 / (P * 0.5)
APPENDIX_B = {"initial position": 30, "scaling": 30, "translation": 3, "small angle": 24, "perspective": 44, "intensity": 146,
              "back surface": 146, "assembling triangles": 72}

GRAPH = [
    Claim("4.3, 5", "processors", 482, lambda e: graph_of(e, 4, 4)["nodes"]),
    Claim("4.3", "processors with five neighbours", 12, lambda e: graph_of(e, 4, 4)["degrees"][5]),
    Claim("4.3", "processors with six neighbours", 470, lambda e: graph_of(e, 4, 4)["degrees"][6], implied=P - 12,
          implied_by="482 less 12 pentagons"),
    Claim("4.3, by Euler's formula", "links", 1440, lambda e: graph_of(e, 4, 4)["edges"], implied=3 * (P - 2),
          implied_by="a triangulation of 482 points"),
    Claim("4.3, by Euler's formula", "triangles", 960, lambda e: graph_of(e, 4, 4)["edges"] - graph_of(e, 4, 4)["nodes"] + 2),
    Claim("5.1.2.1", "triangles a processor, about", 2, lambda e: (graph_of(e, 4, 4)["edges"] - P + 2) / P, "", CLOSE),
    Claim("4.6.2", "planar", "yes", lambda e: graph_of(e, 4, 4)["planar"]),
    Claim("4.6.2", "degree", 6, lambda e: max(graph_of(e, 4, 4)["degrees"])),
    Claim("5.2.2", "greatest distance a message can have (diameter)", 20, lambda e: graph_of(e, 4, 4)["diameter"], "hops"),
    Claim("4.6.2, equation 8", "radius: .82 sqrt(p)", 0.82 * sqrt(P), lambda e: graph_of(e, 4, 4)["radius"], "hops", ROUNDED,
          implied=sqrt(pi * sqrt(3) * P / 8), implied_by="equation 7"),
    Claim("4.6.2", "the radius is the distance of the poles", 0.82 * sqrt(P), lambda e: graph_of(e, 4, 4)["diameter"], "hops", ROUNDED,
          "The poles are 20 hops apart, the diameter; 18 is the radius of the graph.", implied=20,
          implied_by="5.2.2, longest message of 180 degrees"),
    Claim("4.6.2", "diameter over radius: about 1", 1, lambda e: graph_of(e, 4, 4)["diameter"] / graph_of(e, 4, 4)["radius"], "",
          Tolerance(percent=15)),
    Claim("5.1", "P31-123: phi", 30.7278, lambda e: place_of(e, "P31-123")[0], "degrees", PLACE,
          note="0.001 degrees more, unexplained; the other angle agrees to its last digit."),
    Claim("5.1", "P31-123: theta", 122.5887, lambda e: place_of(e, "P31-123")[1], "degrees", PLACE),
    Claim("5.1", "P31-123: neighbours", "P20-120 P24-129 P28-114 P36-117 P36-131 P41-123",
          lambda e: " ".join(sorted(place_of(e, "P31-123")[2]))),
]


def pole_share(degrees):
    """Equation 21: mod(phi, 180)/180 sqrt(p)."""
    return degrees % 180 / 180 * sqrt(P)


def linearity(emulator):
    shares = rotation(emulator, 180)["utilisation"]
    return float(numpy.corrcoef(range(len(shares)), shares)[0, 1])


def over_least(found):
    """Rounds over those of an undelayed longest message."""
    return found["rounds"] / (found["longest"] + 1)


def share_of_routes(emulator, low, high):
    hops = drawing(emulator, "sphere")["routes"]
    return sum(count for length, count in hops.items() if low <= length <= high) / sum(hops.values())


def rotations():
    claims = []
    for degrees, figure, longest, rounds in ((6, 20, 1, 2), (30, 21, 3, 5), (180, 22, 20, 26)):
        where = f"5.2.2, figure {figure}"
        claims += [
            Claim(where, f"rotation by {degrees} degrees: longest route", longest, lambda e, d=degrees: rotation(e, d)["longest"], "hops"),
            Claim(where, f"rotation by {degrees} degrees: rounds", rounds, lambda e, d=degrees: rotation(e, d)["rounds"], "rounds"),
            Claim("5.3.1, equation 21", f"rounds of a rotation by {degrees} degrees", pole_share(degrees),
                  lambda e, d=degrees: rotation(e, d)["rounds"], "rounds", ROUNDED, "mod(180, 180) is 0." if degrees == 180 else "",
                  implied=rounds, implied_by=f"its simulation, figure {figure}")]
    return claims


ANOTHER_OWNER = ("A triangle here goes on to the processor that owns the pixel at its centre; the thesis stops within a processor's width of it. "
                 "Its size of picture is not stated.")
CROWDED = ("Triangles from some five processors pass through one near the sphere's edge, ten messages beside its own two: ten rounds do not suffice. "
           "At a scale of 0.7 the longest route is 9 as published, in 17 rounds; at 0.5 it is 7, in 13.")
MESSAGES = [
    *rotations(),
    Claim("5.2.2, figure 22", "rotation by 180 degrees: senders fall linearly (correlation with the round)", (None, -0.9), linearity,
          note="The curve is not legible, the bound is ours; ours falls slowly at first and slowly at last."),
    Claim("6", "processors that send at first, rotation by 180 degrees", (0.5, 1), lambda e: rotation(e, 180)["utilisation"][0]),
    Claim("6", "processors that send at first, rotation by 30 degrees", (0.5, 1), lambda e: rotation(e, 30)["utilisation"][0]),
    Claim("6", "processors that send at first, rotation by 6 degrees", (0.5, 1), lambda e: rotation(e, 6)["utilisation"][0], "", EXACT,
          "Six degrees are less than most processors' width: only facets near the poles and those beside an edge leave. Figure 20's curve is not "
          "legible."),
    Claim("5.2.1", "rounds of an undelayed message of one hop", 2, lambda e: rotation(e, 6)["rounds"], "rounds"),
    Claim("5.1.8.2", "worst route by great circles and by small circles: the same", 0,
          lambda e: rotation(e, 180, "great_circle")["longest"] - rotation(e, 180)["longest"], "hops"),
    Claim("5.1.8.2", "small circles take more rounds than great circles, rotation by 180 degrees", (0, None),
          lambda e: rotation(e, 180)["rounds"] - rotation(e, 180, "great_circle")["rounds"], "rounds", EXACT,
          "Every great circle crosses a pole: the processors beside it pass on 58 facets each. Small circles spread the load."),
    Claim("5.2.2, figure 18", "drawing the sphere: processors that have a message at first", 0.55, lambda e: drawing(e, "sphere")["utilisation"][0],
          "",
          Tolerance(margin=0.02)),
    Claim("5.2.2, figure 18", "drawing the sphere: most messages go 2 to 6 hops", (0.5, None), lambda e: share_of_routes(e, 2, 6)),
    Claim("5.2.2, figure 18", "drawing the sphere: longest route", 9, lambda e: drawing(e, "sphere")["longest"], "hops", EXACT, ANOTHER_OWNER),
    Claim("5.2.2, beside figure 23", "drawing the sphere: longest route", 6, lambda e: drawing(e, "sphere")["longest"], "hops", EXACT, ANOTHER_OWNER,
          implied=9, implied_by="5.2.2, beside figure 18"),
    Claim("5.2.2, figure 18", "drawing the sphere: rounds", 10, lambda e: drawing(e, "sphere")["rounds"], "rounds", EXACT, CROWDED),
    Claim("5.2.2, figure 18", "drawing the sphere: rounds more than the longest route", 1,
          lambda e: drawing(e, "sphere")["rounds"] - drawing(e, "sphere")["longest"], "rounds", EXACT, CROWDED),
    Claim("5.3.1", "rotation by 180 degrees: rounds over the least possible", 1.2, lambda e: over_least(rotation(e, 180)), "times", CLOSE, "",
          26 / 21,
          "its simulation, figure 22"),
    Claim("5.3.3", "drawing the sphere: rounds over the least possible", (None, 1.2), lambda e: over_least(drawing(e, "sphere")), "times",
          CLOSE, CROWDED, 10 / 10,
          "its simulation, figure 18"),
    *(Claim("5.2.2", f"drawing the sphere turned by {degrees} degrees: rounds as unturned", 0,
            lambda e, d=degrees: rounds_of(e, "small_circle", "transfer", scene__object="sphere", scene__rotate__start=d)["rounds"]
            - drawing(e, "sphere")["rounds"], "rounds", Tolerance(margin=1), "") for degrees in (6, 30, 180)),
    Claim("5.2.2, figure 23", "drawing the cube: longest route", 3, lambda e: drawing(e, "cube")["longest"], "hops", EXACT,
          ANOTHER_OWNER + " At a scale of 0.5 it is 5."),
    Claim("5.2.2, figure 23", "drawing the cube: rounds", 5, lambda e: drawing(e, "cube")["rounds"], "rounds", EXACT,
          "Longer routes, and two triangles a processor of the front face; at a scale of 0.6 it takes 7 rounds."),
    *(Claim("5.2.2", f"{degrees} degrees a frame at 30 frames/s", turns, None, "turns/s", CLOSE, because, degrees * 30 / 360,
            "30 frames of that angle")
      for degrees, turns, because in ((6, 0.5, "Arithmetic, and right."), (30, 3, "Rounded up?"), (180, 15, "Arithmetic, and right."))),
    Claim("figure 19", "picture of the sphere", "a picture", None, because=NO_FIGURE),
    Claim("figure 24", "picture of the cube, edges rounded", "a picture", None, because=NO_FIGURE),
    *(Claim(f"figure {figure}", f"the {name}: pixels within 2 grey levels of the reference renderer (our aim, the thesis has none)", (99, None),
            lambda e, n=name: agreement(e, *setting(scene__object=n)), "%") for figure, name in ((19, "sphere"), (24, "cube"))),
]


def decision(emulator):
    """u of routing a hop that a facet or a triangle makes, sphere turned by 180 degrees, moves and branches free."""
    records = {}
    statistics, _ = emulator.run("geodesic482", *setting(scene__object="sphere", scene__rotate__start=180, nodes__cost__move=0,
                                                         nodes__cost__branch=0),
                                 records=records)
    routing = next(activity["busy_ps"] for activity in statistics["activities"] if activity["name"] == "route")
    return routing / statistics["u_ps"] / sum(row["kind"] in "15" for row in records["messages"])


def bytes_of(emulator, name):
    """Mean length of a message of a phase of the sphere's frame."""
    statistics, _ = emulator.run("geodesic482", *setting(scene__object="sphere"))
    found = next(phase for phase in statistics["phases"] if phase["name"] == name)
    return found["bytes"] / found["messages"]


def message_share(emulator):
    found = frame_of(emulator)
    return 100 * (found["rotate"] + found["transfer"]) / found["frame"]


UNEVEN = ("The thesis spreads triangles evenly over the covered processors; they are not even: the busiest draws four times the mean. A triangle "
          "also costs about 500 u before its rows (257 there), and parts of rows that others own cost those, too.")
TIMES = [
    Claim("5.3.1", "deciding about a hop", 16, decision, "u", EXACT, "Reception, queues and idle turns of the main loop are in ours, which counts "
          "every addition and comparison of the code; the thesis counts the division and six operations of the formula.",
          10 + 3 + 3, "1 division, 3 subtractions, 3 comparisons"),
    Claim("5.3.3", "message that describes a triangle", 48, lambda e: bytes_of(e, "transfer"), "bytes", EXACT,
          "34 bytes suffice: 16-bit coordinates, depths and intensities of three corners, destination and header."),
    Claim("5.3.2, appendix B", "message to a neighbour with a point", 48, lambda e: bytes_of(e, "points"), "bytes", EXACT,
          "8 bytes and 8 a point; the thesis' 48 may be all six neighbours' together, 8 each."),
    Claim("5.3.4", "message with a part of a row", 20, lambda e: bytes_of(e, "draw"), "bytes"),
    *(Claim("5.3.4, after Parke", what, cost, None, "u", EXACT, f"Not measured one by one; ours, in u with moves and branches: {ours} "
            "(docs/geodesic-program.md).", implied, "62 an edge, 71 a polygon")
      for what, cost, ours, implied in (("a pixel", 9, "8 to 10", None), ("a row", 61, "90", None), ("a triangle", 257, "about 500", 3 * 62 + 71))),
    Claim("5.3.4", "a triangle of a pixel or so", 4, None, "u", because="Our program has no case of its own for them."),
    Claim("appendix A", "memory of a processor for pixels and their depths", 1000, None, "bytes",
          because="Ours keeps a word and a byte a pixel: 408 bytes on the mean of 136 pixels, 2430 beside the poles."),
    Claim("appendix B", "position, intensity and assembly, a crossing, without messages", 495, None, "u", CLOSE,
          "Not measured by crossing: phases are. Ours, by the program's parts: 345 u a facet, 280 u a crossing (docs/geodesic-program.md).",
          sum(APPENDIX_B.values()), "sum of its rows"),
    *(Claim("appendix B", name, cost, None, "u", because="Our program is not divided so.") for name, cost in APPENDIX_B.items()),
    Claim("5.3.2", "position, intensity and assembly, a crossing: text", 600, lambda e: frame_of(e)["points"] + frame_of(e)["assemble"], "u", CLOSE,
          "Ours is of a sphere, which has one crossing a processor.", 500 + 48, "equation 23, m = 1"),
    Claim("5.3.5", "Cr, rotation by 6 degrees", 66, lambda e: frame_of(e)["rotate"], "u", CLOSE,
          "The thesis leaves out that processors clear their pixels, and takes 6/180 of the longest route, less than one hop."),
    Claim("5.3.5", "Ci, positions, intensities, assembly", 1096, lambda e: frame_of(e)["points"] + frame_of(e)["assemble"], "u", CLOSE,
          "For one crossing a processor, where the thesis takes two: a facet costs 345 u before its crossings. Positions and intensities alone take "
          "1119 u; points that after a rotation are two processors away must be asked for.", 2 * (500 + 48),
          "equation 23"),
    Claim("5.3.5", "Ct, triangles to the owners of pixels", 800, lambda e: frame_of(e)["transfer"], "u", CLOSE,
          "Ours walks on to the true owner.", CT, "equation 24, halved for a centred picture"),
    Claim("5.3.5", "Cs, drawing", 3680, lambda e: frame_of(e)["draw"], "u", CLOSE, UNEVEN, CS, "equation 33"),
    Claim("5.3.5", "T, the whole frame", 5642, lambda e: frame_of(e)["frame"], "u", CLOSE, UNEVEN, 66 + 1096 + 800 + 3680, "sum of its parts"),
    Claim("5.3.5", "frame at u = 5 microseconds: within 1/30 s", (None, 1000 / 30), lambda e: frame_of(e)["picoseconds"] / 1e9, "ms", EXACT, UNEVEN,
          implied=5642 * 5e-3, implied_by="5642 u of 5 microseconds"),
    Claim("5.3.5", "frame at u = 1 microsecond: within 1/30 s", (None, 1000 / 30), lambda e: frame_of(e, u="1us")["picoseconds"] / 1e9, "ms"),
    Claim("5.3.5", "frames/s at u = 5 microseconds", 35.4, lambda e: 1e12 / frame_of(e)["picoseconds"], "1/s", CLOSE, UNEVEN, 1e6 / (5 * 5642),
          "5642 u of 5 microseconds"),
    Claim("5.3.5, 6", "share of messages (Cr and Ct) in the frame", 15, message_share, "%", CLOSE, "Drawing takes longer, so the share is less.",
          100 * (66 + 800) / 5642, "its parts"),
    Claim("abstract, 5.3.5, 6", "frames/s grow nearly as the processors do: 122 to 482 processors", 482 / 122,
          lambda e: frame_of(e, b=2, c=2)["frame"] / frame_of(e)["frame"], "times", Tolerance(percent=20),
          "More processors hold more facets and so draw more triangles; the busiest one's share of the picture falls more slowly than the mean."),
    Claim("abstract, 5.3.5, 6", "the same, 482 to 1922 processors", 1922 / 482,
          lambda e: frame_of(e)["frame"] / frame_of(e, b=8, c=8)["frame"], "times", Tolerance(percent=20), "As above; routes are twice as long."),
]

CLAIMS = [*GRAPH, *MESSAGES, *TIMES]
