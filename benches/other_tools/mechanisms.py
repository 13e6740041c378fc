"""The three mechanisms, their exact positions in 40 digits, and the distance of the two pins that should be one.

Crank, coupler, rocker and frame are in millimetres. The crank turns about the origin, the rocker about (frame, 0).
Angles are in radians and are measured from the frame.
"""

import math
from dataclasses import dataclass

import mpmath

mpmath.mp.dps = 40


@dataclass(frozen=True)
class FourBar:
    crank: float
    coupler: float
    rocker: float
    frame: float


FOUR_BAR = FourBar(50.0, 120.0, 100.0, 140.0)
PARALLELOGRAM = FourBar(50.0, 140.0, 50.0, 140.0)
# The four-bar with a rocker too short: its crank does not pass 137.37 degrees.
SHORT_ROCKER = FourBar(50.0, 120.0, 60.0, 140.0)

START = math.radians(30.0)
RPM = 60.0


@dataclass(frozen=True)
class Position:
    """Angles of coupler and rocker with the first derivatives with respect to the crank's angle, and the pin."""

    theta: mpmath.mpf
    psi: mpmath.mpf
    theta_1: mpmath.mpf
    psi_1: mpmath.mpf
    pin: tuple


def exact(bar, phi, sign=1):
    """Returns the position at `phi`; `sign` is +1 for the pin on the left of the line from crank to frame pivot.

    Returns `None` where the mechanism cannot close.
    """
    phi = mpmath.mpf(phi)
    crank, coupler, rocker, frame = (mpmath.mpf(x) for x in (bar.crank, bar.coupler, bar.rocker, bar.frame))
    ax, ay = crank * mpmath.cos(phi), crank * mpmath.sin(phi)
    dx, dy = frame - ax, -ay
    distance = mpmath.sqrt(dx * dx + dy * dy)
    along = (distance**2 + coupler**2 - rocker**2) / (2 * distance)
    square = coupler**2 - along**2
    if square < 0:
        return None
    across = sign * mpmath.sqrt(square)
    px = ax + (along * dx - across * dy) / distance
    py = ay + (along * dy + across * dx) / distance
    theta = mpmath.atan2(py - ay, px - ax)
    psi = mpmath.atan2(py, px - frame)
    # Derivative of the loop: the parts along the coupler give psi', those along the rocker give theta'.
    sine = mpmath.sin(theta - psi)
    theta_1 = psi_1 = mpmath.nan
    if abs(sine) > mpmath.mpf(10) ** -30:
        psi_1 = crank * mpmath.sin(theta - phi) / (rocker * sine)
        theta_1 = crank * mpmath.sin(psi - phi) / (coupler * sine)
    return Position(theta, psi, theta_1, psi_1, (px, py))


def gap_of_angles(bar, phi, theta, psi):
    """Returns the distance of coupler's end and rocker's end for given angles, without rounding of its own."""
    phi, theta, psi = mpmath.mpf(phi), mpmath.mpf(theta), mpmath.mpf(psi)
    x = bar.crank * mpmath.cos(phi) + bar.coupler * mpmath.cos(theta) - bar.frame - bar.rocker * mpmath.cos(psi)
    y = bar.crank * mpmath.sin(phi) + bar.coupler * mpmath.sin(theta) - bar.rocker * mpmath.sin(psi)
    return float(mpmath.hypot(x, y))


def gap_of_points(bar, a, pin):
    """Returns the same distance for tools that return the pins: each link has its length and points at `pin`."""
    theta = mpmath.atan2(mpmath.mpf(pin[1]) - mpmath.mpf(a[1]), mpmath.mpf(pin[0]) - mpmath.mpf(a[0]))
    psi = mpmath.atan2(mpmath.mpf(pin[1]), mpmath.mpf(pin[0]) - bar.frame)
    x = mpmath.mpf(a[0]) + bar.coupler * mpmath.cos(theta) - bar.frame - bar.rocker * mpmath.cos(psi)
    y = mpmath.mpf(a[1]) + bar.coupler * mpmath.sin(theta) - bar.rocker * mpmath.sin(psi)
    return float(mpmath.hypot(x, y))


def is_crossed(phi, psi):
    """Returns whether a parallelogram linkage is crossed, for a position away from the change points."""
    return abs(math.remainder(psi - phi, 2 * math.pi)) > 0.1


def away_from_change_point(phi):
    return abs(math.sin(phi)) > 0.3


def rod(length):
    """Returns mass (kg) and moment of inertia about the centre (kg m2) of a rod of 8 mm and 1000 kg/m3."""
    length = length / 1000.0
    mass = 1000.0 * math.pi * 0.004**2 * length
    return mass, mass * length**2 / 12.0
