# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Irradiance of the benchmark's scenes by Mitsuba 3, one thread; `make_light_chart.py` runs it in a Python
that has mitsuba, with the directory of the scenes, and reads rows of CSV from its output:
scene, method, samples per sensor, seconds, nRMSE, mean over the reference's mean.

Each method is tried with two samplers:
  emitter   the emitter's own sampling and a shadow ray (area lights)
  cosine    directions by the cosine with the normal, and a shadow ray (skies)
  path      the path integrator of one bounce, looking at the floor
Seconds are processor time without loading and compiling, the median of three runs, or one of more than 0.2 s.
"""

from __future__ import annotations

import json
import statistics
import sys
import time
from pathlib import Path

import drjit as dr
import mitsuba as mi
import numpy as np

mi.set_variant(sys.argv[2])
dr.set_thread_count(1)

from mitsuba import Float, Point2f, Point3f, UInt32, Vector3f  # noqa: E402  after the choice of variant


def radiance_of_sky(scene: dict, x, y, z, lib):
    """CIE's formula, 1 at the zenith, for numpy (lib) or Dr.Jit."""
    a, b, c, d, e, base = scene["sky"]
    sun = np.array(scene["sun"]) / np.linalg.norm(scene["sun"])

    def indicatrix(chi, cosine, exp):
        return base + c * exp(d * chi) + e * cosine * cosine

    cosine = lib.clip(x * sun[0] + y * sun[1] + z * sun[2], -1.0, 1.0)
    acos = np.arccos if lib is np else dr.acos
    zenith = (1 + a * np.exp(b)) * indicatrix(np.arccos(sun[2]), sun[2], np.exp)
    gradation = 1 + a * lib.exp(b / lib.maximum(z, 1e-6))
    return gradation * indicatrix(acos(cosine), cosine, lib.exp) / zenith


def environment(scene: dict) -> dict:
    height, width = 512, 1024
    theta = (np.arange(height)[:, None] + 0.5) * np.pi / height
    phi = (np.arange(width)[None, :] + 0.5) * 2 * np.pi / width
    x, y = np.sin(phi) * np.sin(theta), np.cos(phi) * np.sin(theta)
    z = np.cos(theta) + 0 * phi
    values = np.where(z > 0, radiance_of_sky(scene, x, y, z, np), 0.0)
    bitmap = mi.Bitmap(np.repeat(values[:, :, None], 3, axis=2).astype(np.float32))
    return {
        "type": "envmap",
        "bitmap": bitmap,
        "to_world": mi.ScalarTransform4f().rotate([1, 0, 0], 90),
    }


class Task:
    def __init__(self, directory: Path, scene: dict):
        self.scene = scene
        base = directory / scene["key"]
        corners = np.fromfile(f"{base}.triangles").reshape(-1, 3)
        sensors = np.fromfile(f"{base}.sensors").reshape(-1, 3)
        self.exact = np.fromfile(f"{base}.exact")
        mesh = mi.Mesh("mesh", len(corners), len(corners) // 3)
        parameters = mi.traverse(mesh)
        parameters["vertex_positions"] = dr.ravel(Point3f(*corners.T.astype(np.float32)))
        parameters["faces"] = dr.arange(UInt32, len(corners))
        parameters.update()
        world = {"type": "scene", "mesh": mesh, "path": {"type": "path", "max_depth": 2}}
        if "polygon" in scene:
            polygon = np.array(scene["polygon"])
            middle, size = polygon.mean(axis=0), np.ptp(polygon, axis=0) / 2
            place = (
                mi.ScalarTransform4f()
                .translate(list(middle))
                .rotate([1, 0, 0], 180)
                .scale([*size[:2], 1])
            )
            emitter = {"type": "area", "radiance": scene["radiance"]}
            world["light"] = {"type": "rectangle", "to_world": place, "emitter": emitter}
        else:
            world["light"] = environment(scene)
        self.world = mi.load_dict(world)
        self.points = Point3f(*sensors.T.astype(np.float32))
        dr.eval(self.points)

    def methods(self) -> dict:
        first = {"emitter": self.emitter} if "polygon" in self.scene else {"cosine": self.cosine}
        return {**first, "path": self.path}

    def surface(self, points: Point3f) -> mi.SurfaceInteraction3f:
        si = dr.zeros(mi.SurfaceInteraction3f, dr.width(points))
        si.p = points
        si.t = 1.0
        si.n = mi.Normal3f(0, 0, 1)
        si.sh_frame = mi.Frame3f(Vector3f(0, 0, 1))
        return si

    def emitter(self, points: Point3f, sampler: mi.Sampler) -> Float:
        sample, value = self.world.sample_emitter_direction(
            self.surface(points), sampler.next_2d(), True
        )
        return value.x * dr.maximum(sample.d.z, 0)

    def cosine(self, points: Point3f, sampler: mi.Sampler) -> Float:
        direction = mi.warp.square_to_cosine_hemisphere(Point2f(sampler.next_2d()))
        hidden = self.world.ray_test(self.surface(points).spawn_ray(direction))
        light = radiance_of_sky(self.scene, direction.x, direction.y, direction.z, dr)
        return dr.select(hidden, 0, np.pi * light)

    def path(self, points: Point3f, sampler: mi.Sampler) -> Float:
        ray = mi.RayDifferential3f(points + Vector3f(0, 0, 1e-2), Vector3f(0, 0, -1))
        value, _, _ = self.world.integrator().sample(self.world, sampler, ray)
        reflectance = 0.5  # of a mesh by default
        return value.x * (np.pi / reflectance)

    def irradiance(self, method, sampler: str, samples: int, seed: int) -> tuple[np.ndarray, float]:
        start = time.process_time()
        count = len(self.exact)
        generator = mi.load_dict({"type": sampler, "sample_count": samples})
        generator.set_samples_per_wavefront(samples)
        generator.seed(seed, count * samples)
        owner = dr.arange(UInt32, count * samples) // samples
        values = method(dr.gather(Point3f, self.points, owner), generator)
        sums = dr.block_sum(values, samples)
        dr.eval(sums)
        dr.sync_thread()
        seconds = time.process_time() - start
        return np.array(sums) / samples, seconds


def main() -> None:
    directory = Path(sys.argv[1])
    print(f"# Mitsuba {mi.__version__}, {mi.variant()}", flush=True)
    for scene in json.loads((directory / "scenes.json").read_text()):
        task = Task(directory, scene)
        for name, method in task.methods().items():
            for sampler in ("independent", "multijitter"):
                for samples in (64, 256, 1024, 4096):
                    errors, seconds, values = [], [], None
                    for seed in range(4):
                        values, elapsed = task.irradiance(method, sampler, samples, seed)
                        if seed > 0:  # the first may compile
                            seconds.append(elapsed)
                            errors.append(np.mean((values - task.exact) ** 2))
                        if elapsed > 0.2 and seconds:
                            break
                    error = np.sqrt(np.mean(errors)) / task.exact.mean()
                    row = [
                        scene["key"],
                        f"{name}, {sampler}",
                        samples,
                        statistics.median(seconds),
                        error,
                    ]
                    print(*row, values.mean() / task.exact.mean(), sep=";", flush=True)


if __name__ == "__main__":
    main()
