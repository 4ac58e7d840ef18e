# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What each structure costs on a surface, and which rays it gets wrong."""

import lumitree

torus = lumitree.scene("torus", resolution=24)
rows = lumitree.accuracy_chart(torus, 400)
for kind in ("Random", "ThroughVertex"):
    print(f"{kind:34} ns/ray  leaks  other triangles")
    for row in sorted((r for r in rows if r["RayKind"] == kind), key=lambda r: r["NanosecondsPerRay"]):
        name = f"{row['BackEnd']} {row['Setting']} {row['Precision']}"
        print(f"{name:34} {row['NanosecondsPerRay']:6.0f} {row['Leaks']:6} {row['OtherPrimitives']:16}")

assert all(not row["Leaks"] for row in rows if row["Precision"] in ("watertight", "exact"))
