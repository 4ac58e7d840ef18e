# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a camera in a room would measure: luminance, pixel by pixel, and whether a luminaire glares."""

import numpy as np

import lumitree

# The Cornell box in metres: its surfaces reflect what its cell array Reflectance says.
room = lumitree.scene("cornell_box", resolution=4)
panel = lumitree.rectangle_light(
    (0.35, 0.35, 0.99), (0.35, 0.65, 0.99), (0.65, 0.35, 0.99), flux=900.0, system="photometric"
)
camera = lumitree.camera_rays((0.5, -1.2, 0.5), (0.5, 0.5, 0.5), angle=40, near=1.25, size=(160, 120))
picture = lumitree.radiance(camera, lights=panel, occluders=room, reflectance=0.5)
print(f"{picture.name}: from {picture.values.min():.0f} to {picture.values.max():.0f}")

# The panel's luminance is its flux over pi times its area, from wherever it is seen.
own = 900.0 / (np.pi * 0.3 * 0.3)
eye = np.array((0.5, 0.1, 0.3))
ways = np.array((0.5, 0.5, 0.99)) - eye
for step in (0.0, 0.3, 0.6):
    seen = lumitree.radiance(eye + step * ways, ways, panel, room)
    assert abs(seen.values[0] - own) < 1e-9 * own

# From a seat, by direction: radiance x cosine x solid angle adds up to the illuminance.
seat = lumitree.sensor_grid((0.2, 0.05, 0.3), (0.3, 0.05, 0.3), (0.2, 0.15, 0.3), spacing=1)
around = lumitree.radiance_around([(0.25, 0.1, 0.3)], panel, room, rings=180, sectors=360)
summed = (around.values[0] * around.solid_angles * np.maximum(0, around.directions[:, 2])).sum()
exact = lumitree.irradiance(seat, panel, room).values[0]
print(f"at the seat {summed:.1f} lx by direction, {exact:.1f} lx in closed form")
assert abs(summed - exact) < 0.02 * exact
