"""Pictures and plots for notebooks, with matplotlib (pip install lancret[notebook]).

lancret.notebook.picture(groom.expand(0))
lancret.notebook.histograms(groom.expand())
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from .errors import InputError

if TYPE_CHECKING:
    from .curves import Curves

Doubles = npt.NDArray[np.float64]

#: Name, axis to the right and axis upwards, for Y up.
_VIEWS = (("front", 0, 1), ("side", 2, 1), ("top", 0, 2))


def _pyplot() -> Any:
    try:
        from matplotlib import pyplot
    except ImportError as fault:
        raise ImportError(
            "lancret.notebook needs matplotlib: pip install 'lancret[notebook]'"
        ) from fault
    return pyplot


def picture(
    curves: Curves,
    *,
    time: int = 0,
    max_strands: int = 2000,
    up: int = 1,
    size: float = 4,
    colour: str | None = None,
) -> Any:
    """A figure with views of the strands along the three axes, as lines. Draws at most
    `max_strands`, evenly chosen. `up`: the axis that points up, 1 for Y and 2 for Z.
    `time`: an index into the curves' times. Without `colour`, roots are dark and tips
    light."""
    pyplot = _pyplot()
    from matplotlib.collections import LineCollection

    lines = _lines(curves, time, max_strands)
    figure, axes = pyplot.subplots(
        1, len(_VIEWS), figsize=(size * len(_VIEWS), size), layout="constrained"
    )
    order = np.array([0, 1, 2] if up == 1 else [0, 2, 1])
    for axis, (name, across, upwards) in zip(axes, _VIEWS):
        columns = order[[across, upwards]]
        flat = [line[:, columns] for line in lines]
        segments = np.concatenate([np.stack([f[:-1], f[1:]], axis=1) for f in flat])
        along = np.concatenate([np.linspace(0, 1, len(f) - 1) for f in flat])
        style = {"colors": colour} if colour else {"array": along, "cmap": "copper"}
        axis.add_collection(
            LineCollection(list(segments), linewidths=0.6, alpha=0.7, **style)
        )
        axis.autoscale()
        axis.set_aspect("equal")
        if name == "top" and up == 1:  # from above, Z points down the page
            axis.invert_yaxis()
        axis.set_title(name)
        axis.set_xlabel("xyz"[columns[0]])
        axis.set_ylabel("xyz"[columns[1]])
    pyplot.close(
        figure
    )  # else a notebook shows it twice, as it shows the cell's result
    return figure


def _lines(curves: Curves, time: int, max_strands: int) -> list[Doubles]:
    """Places along at most `max_strands` strands."""
    if not len(curves):
        raise InputError("there are no strands to draw")
    if max_strands < 1:
        raise InputError(f"max_strands: must be 1 or more, not {max_strands}")
    chosen = np.unique(
        np.linspace(0, len(curves) - 1, min(max_strands, len(curves))).astype(int)
    )
    places, first = curves.some(chosen).places(time=time)
    return [places[a:b, :3] for a, b in zip(first[:-1], first[1:])]


def lengths_and_curvatures(curves: Curves, *, time: int = 0) -> tuple[Doubles, Doubles]:
    """[strands] lengths, and curvatures at all inner places (of the circle through three
    consecutive places), in the curves' unit and its inverse. A strand of two places has
    no curvature."""
    if not len(curves):
        raise InputError("there are no strands to measure")
    places, first = curves.places(time=time)
    steps = np.diff(places[:, :3], axis=0)
    chords = np.linalg.norm(steps, axis=1)
    inside = np.ones(len(chords), dtype=bool)
    inside[first[1:-1] - 1] = False  # steps from one strand to the next
    lengths = np.add.reduceat(np.where(inside, chords, 0), first[:-1])
    turn = np.linalg.norm(np.cross(steps[:-1], steps[1:]), axis=1)
    across = np.linalg.norm(steps[:-1] + steps[1:], axis=1)
    product = chords[:-1] * chords[1:] * across
    valid = inside[:-1] & inside[1:] & (product > 0)
    return lengths, 2 * turn[valid] / product[valid]


def histograms(
    curves: Curves, *, time: int = 0, bins: int = 60, size: float = 4
) -> Any:
    """A figure with histograms of lengths and curvatures."""
    pyplot = _pyplot()
    lengths, curvatures = lengths_and_curvatures(curves, time=time)
    figure, axes = pyplot.subplots(
        1, 2, figsize=(2.5 * size, size), layout="constrained"
    )
    shown = curvatures
    if len(curvatures):
        shown = curvatures[curvatures <= np.quantile(curvatures, 0.995)]
    axes[0].hist(lengths, bins=bins)
    axes[0].set(xlabel="length", ylabel="strands")
    axes[1].hist(shown, bins=bins)
    axes[1].set(xlabel="curvature, without the largest 0.5 %", ylabel="places")
    pyplot.close(figure)
    return figure
