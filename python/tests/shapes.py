"""Hair and a scalp from formulas."""

import numpy as np

import lancret


def lawn(n=5, side=4.0, length=5.0, points=24):
    """n * n curls on a square in the plane Z = 0."""
    t = np.linspace(0, 1, points)
    curl = length * np.stack(
        [0.04 * (np.cos(9 * t) - 1), 0.04 * np.sin(9 * t), t], axis=1
    )
    grid = side * (np.arange(n) + 0.5) / n
    roots = np.stack([*np.meshgrid(grid, grid), np.zeros((n, n))], axis=-1).reshape(
        -1, 1, 3
    )
    return lancret.Strands((roots + curl).reshape(-1, 3), np.full(n * n, points))


def square(side=4.0):
    corners = [[0, 1, 2], [0, 2, 3]]
    uvs = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], np.float32)
    return lancret.Mesh(
        side * np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]),
        corners,
        uvs[corners],
    )
