# SPDX-License-Identifier: MIT
"""The formulas of Chen et al. 1998. a: area of a triangle in pixels; S: side of a tile; k: cost of a triangle in pixels; RHO: area of a bounding
box over its triangle's. Numbers in brackets are its equations."""

from math import inf, sqrt

RHO = 3
K, K_PLAIN, K_TEXTURED = 25, 9.3, 3.6  # hardware; Argus, untextured and textured
WIDTH, HEIGHT = 1024, 768
PIXELS = WIDTH * HEIGHT


def overlap(a, S, rho=RHO):  # (1)
    return ((S + sqrt(rho * a)) / S) ** 2


def r_software(a, k, o):  # (2)
    return (k * o + a) / (k + a)


def r_hardware(a, k, o):  # (3)
    return max(k * o, a) / max(k, a)


def worst_area(k, S, rho=RHO):
    """Appendix: the area at which (2) is greatest; that of (3) is k."""
    return ((k * rho + sqrt(k * k * rho * rho + 4 * k * S * S * rho)) / (2 * S * sqrt(rho))) ** 2


def balance_printed(k, S, rho=RHO):
    """Appendix: k', where k O = a, as it is printed."""
    return ((-k * S * sqrt(rho) - S * S * sqrt(k)) / (k * rho - S * S)) ** 2


def balance(k, S, rho=RHO):
    """k O = a is sqrt(k) (1 + sqrt(rho a) / S) = sqrt(a): infinite where S is at most sqrt(k rho), where the printed formula squares a root below 0."""
    return k * (S / (S - sqrt(k * rho))) ** 2 if S > sqrt(k * rho) else inf


def software_limit(k, S, rho=RHO):
    """Appendix: what (2) tends to for large areas."""
    return 1 + k * rho / (S * S)


def hardware_limit(k, S, rho=RHO):
    """Likewise of (3), which the paper gives as 1."""
    return max(1, k * rho / (S * S))
