# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The ways in which mutants.py breaks the core. A mutant changes each "old", which its file has once, to
"new". The tests named are run first: they are the likeliest to notice."""

from __future__ import annotations

from typing import NamedTuple


class Edit(NamedTuple):
    file: str
    old: str
    new: str


class Mutant(NamedTuple):
    what: str
    tests: str
    edits: tuple[Edit, ...]


def mutant(what: str, tests: str, *edits: str) -> Mutant:
    """edits: file, old, new, and again."""
    return Mutant(what, tests, tuple(Edit(*edits[i : i + 3]) for i in range(0, len(edits), 3)))


RAY_BOX = "Accel/Kernel/RayBox.h"
WIDE_RAY = "Accel/Structures/WideRay-inl.h"
BVH_FRAME = "Accel/Structures/BvhFrame.h"
WIDE_WALK = "Accel/Structures/WideBvhWalk.cxx"
WIDE_STEP = "Accel/Structures/WideStep-inl.h"
BUNDLE = "Accel/Structures/WideBvhBundle.cxx"
BUNDLE_LEAF = "Accel/Kernel/BundleLeaf-inl.h"
FILTER = "Accel/Kernel/BlockFilter-inl.h"
EDGES = "Accel/Kernel/EdgeFilter.h"
CROSSING = "Accel/Kernel/Crossing.h"
PRECISIONS = "Accel/Kernel/Precisions.h"
QUERIES = "Accel/Kernel/Queries.h"
FINISH = "Accel/Kernel/Finish.cxx"
FORMULAS = "Accel/Exact/Formulas.h"
PREDICATES = "Accel/Exact/Predicates.cxx"
LATTICE = "Accel/Exact/Lattice.h"
FIXED = "Accel/Exact/FixedInteger.h"
PLANE_WALK = "Accel/Structures/PlaneWalk.h"
BSP_WALK = "Accel/Structures/BspWalk.h"

ONE_BOX = (
    "const double tFar = (plane(box, this->far_[k]) - this->origin_[k]) * this->reciprocal_[k];\n"
    "      enter = tNear > enter ? tNear : enter;\n      "
)
TWO_BOXES = (
    "const Double2 tFar = (farPlane - this->origin_[k]) * this->reciprocal_[k];\n"
    "      enter = tNear > enter ? tNear : enter;\n      "
)

BOXES = [
    mutant("No pad in the boxes' slab test in double", "Queries Boxes",
           RAY_BOX, "relativePad = 0x1p-40", "relativePad = 0.0"),
    mutant("No pads there, and < for <=", "Boxes",
           RAY_BOX, "relativePad = 0x1p-40", "relativePad = 0.0",
           RAY_BOX, "absolutePad = 0x1p-1000", "absolutePad = 0.0",
           RAY_BOX, "return tEnter <= tExit && tEnter <= tStop;", "return tEnter < tExit && tEnter < tStop;"),
    mutant("< for <= where a box is met at the end of the segment", "Boxes Stress",
           RAY_BOX, "return tEnter <= tExit && tEnter <= tStop;", "return tEnter <= tExit && tEnter < tStop;"),
    mutant("A NaN slab rules the box out", "Boxes Cells",
           RAY_BOX, ONE_BOX + "exit = tFar < exit ? tFar : exit;", ONE_BOX + "exit = exit < tFar ? exit : tFar;"),
    mutant("A NaN slab rules the box out, of two boxes at once", "Boxes Cells Stress",
           RAY_BOX, TWO_BOXES + "exit = tFar < exit ? tFar : exit;", TWO_BOXES + "exit = exit < tFar ? exit : tFar;"),
    mutant("< for <= where one of two boxes is met at the end of the segment", "Boxes Stress",
           RAY_BOX, "(enter <= exit) & (enter <= tStop)", "(enter <= exit) & (enter < tStop)"),
    mutant("Two boxes at once are met without a pad", "Boxes Stress",
           RAY_BOX, "magnitude(enter) * relativePad + absolutePad", "0.0 * magnitude(enter)",
           RAY_BOX, "magnitude(exit) * relativePad + absolutePad", "0.0 * magnitude(exit)"),
    mutant("-0 is taken for a positive direction", "Boxes",
           RAY_BOX, "std::signbit(d)", "d < 0.0"),
    mutant("A reciprocal that overflows constrains", "Boxes",
           RAY_BOX, "if (d != 0.0 && std::isinf(this->reciprocal_[k]))", "if (false)"),
    mutant("A plane's t that overflows rules the box out", "Boxes Stress",
           RAY_BOX, "if (this->passesBeside(box))", "if (true)"),
    mutant("< for <= where what waits begins at the best hit, in four structures", "Stress",
           PLANE_WALK, "while (current.tEnter > tStop);", "while (current.tEnter >= tStop);",
           "Accel/Structures/Bvh.cxx", "while (current.tEnter > tStop);", "while (current.tEnter >= tStop);",
           "Accel/Structures/Octree.cxx", "if (current.tEnter > tStop)", "if (current.tEnter >= tStop)"),
]  # fmt: skip

WIDE_BVH = [
    mutant("No pad in the eight-wide tree's slab test", "Boxes",
           WIDE_RAY, "slabPad = 0x1p-21f", "slabPad = 0.0f"),
    mutant("The far planes' pad with the sign of the near ones'", "Boxes Stress",
           WIDE_RAY, "Float4::all(1.0f + pad)", "Float4::all(1.0f - pad)"),
    mutant("Neither the eight-wide tree's boxes nor its origins are rounded outward", "Boxes Stress",
           WIDE_RAY, "absolute(o) * Double4::all(0x1p-22) + Double4::all(0x1p-120)", "Double4::all(0.0)",
           BVH_FRAME, "v - (std::fabs(v) * 0x1p-23 + 0x1p-120)", "v",
           BVH_FRAME, "v + (std::fabs(v) * 0x1p-23 + 0x1p-120)", "v"),
    mutant("The wrong end of the origin's interval for far planes", "Boxes Stress",
           WIDE_RAY, "whereNegative(along, high, low).store(this->originFar);",
           "whereNegative(along, low, high).store(this->originFar);"),
    mutant("A float reciprocal that overflows constrains", "Cells",
           WIDE_RAY, "std::fabs(this->nearReciprocal[k]) > 0x1p118f", "false"),
    mutant("Far origins overflow: nothing is met from there", "Boxes Stress",
           WIDE_RAY, "std::fill_n(this->originNear, 4, 0x1p100f);", "std::fill_n(this->originNear, 4, -0x1p100f);",
           WIDE_RAY, "std::fill_n(this->originFar, 4, -0x1p100f);", "std::fill_n(this->originFar, 4, 0x1p100f);"),
    mutant("Near and far planes exchanged for one sign", "Triangles",
           WIDE_STEP, "wideArity * (negative ? k + 3 : k)", "wideArity * k"),
    mutant("Boxes behind half of the way to the best hit are passed over", "Stress",
           WIDE_WALK, "this->stack.enter[this->stack.height] <= this->stop",
           "this->stack.enter[this->stack.height] <= 0.5f * this->stop"),
    mutant("Children are pushed in another order than their entries", "Stress",
           WIDE_STEP, "compress(ordered(hn::LoadU(du, node.child)), waiting, bits)",
           "compress(hn::LoadU(du, node.child), waiting, bits)"),
    mutant("AVX2's table of lanes leaves out the last lane", "Numbers",
           WIDE_STEP, "lane < 8; ++lane", "lane < 7; ++lane"),
    mutant("Lane by lane, the mask is read at the place and not at the lane", "Numbers",
           WIDE_STEP, "(met >> lane & 1u)", "(met >> i & 1u)"),
    mutant("When all eight children are met none is pushed", "Stress",
           WIDE_STEP, "static_cast<int>(hwy::PopCount(bits))", "static_cast<int>(hwy::PopCount(bits) & 7)"),
    mutant("An octant's order names half of the lanes twice", "Stress",
           "Accel/Structures/WideBvhOrder.cxx",
           "this->visit(rightIsNear ? split.right : split.left, octant, order, at);",
           "this->visit(rightIsNear ? split.left : split.right, octant, order, at);"),
    mutant("A ray that ends takes another one off the way", "Stress AgainstBruteForce",
           WIDE_WALK, "onTheWay[i] = onTheWay[--active];", "--active;"),
    mutant("The next ray fed is not started", "Stress AgainstBruteForce",
           WIDE_WALK, "traveller.await(*traveller.state);\n        ++i;", "++i;"),
    mutant("Interleaved rays share one state", "Stress AgainstBruteForce",
           WIDE_WALK, "travellers[i].await(states[i]);", "travellers[i].await(states[0]);"),
]  # fmt: skip

BUNDLES = [
    mutant("Bundles: far planes by the fastest ray, not by the slowest", "Queries",
           BUNDLE, "sign / smallest * (1.0f + WideRay::slabPad)", "sign / largest * (1.0f + WideRay::slabPad)"),
    mutant("Bundles: rays of two octants go together", "Queries",
           BUNDLE, "smallest > (k == bundle.axis ? 0.25f : 0x1p-100f)", "smallest > -8.0f"),
    mutant("Bundles: a better hit stops its ray half of the way", "Queries",
           BUNDLE, "this->hull.above(bundle.high[i])", "0.5f * this->hull.above(bundle.high[i])"),
    mutant("Bundles: edge functions have no error", "Queries",
           BUNDLE_LEAF, "c.error = Double8::all(seen.bound[triangle])", "c.error = Double8::all(0.0)"),
    mutant("Bundles: the nearer of two hits whose intervals overlap is not settled", "Queries",
           BUNDLE_LEAF, "const auto nearer = high < ofRays(bundle.low);", "const auto nearer = t < ofRays(bundle.high);"),
    mutant("Bundles: limits are compared with the computed t", "Queries",
           BUNDLE_LEAF, "(ofRays(bundle.tMin) < low) & (high < ofRays(bundle.tMax))",
           "(ofRays(bundle.tMin) < t) & (t < ofRays(bundle.tMax))"),
    mutant("Bundles: a vague t is taken as it is", "Queries",
           BUNDLE_LEAF, "(high - low) < absolute(t) * Double8::all(0x1p-27)", "(high - low) < absolute(t)"),
    mutant("Bundles: Fast does not ask where the ray enters the triangle's box", "Queries",
           BUNDLE_LEAF, ": isKey(bundle, corners, c.first, t);", ": t <= t;"),
]  # fmt: skip

LEAF = [
    mutant("The bound of edge functions halved", "FilterBound",
           EDGES, "edgeBound = 16 * 0x1p-53", "edgeBound = 8 * 0x1p-53"),
    mutant("The bound of edge functions a hundredth", "FilterBound",
           EDGES, "edgeBound = 16 * 0x1p-53", "edgeBound = 0.16 * 0x1p-53"),
    mutant("Nothing added to the bound for underflow", "FilterBound Triangles",
           EDGES, "this->boundFloor = 0x1p-1020 * (1.0 + this->oneNorm);", "this->boundFloor = 0.0;"),
    mutant("The block's filter has no bound", "Triangles Stress",
           FILTER, "Double4::all(FilterRay::edgeBound / 2)", "Double4::all(0.0)"),
    mutant("A candidate gets its bound from the block's first lane", "FilterBound",
           FILTER, "e.error = this->at(this->error, lane);", "e.error = this->at(this->error, 0);"),
    mutant("A candidate gets an edge function of its neighbour", "Triangles Stress",
           FILTER, "e.w = this->at(this->f[2], lane);", "e.w = this->at(this->f[2], lane ^ 1);"),
    mutant("The block's longest edge is that of its first triangle", "Stress FilterBound",
           "Accel/Kernel/TriangleBlock.h", "edge > block.edge ? edge : block.edge",
           "lane == 0 && edge > block.edge ? edge : block.edge"),
    mutant("Contraction: single triangles' edge functions by fma, blocks' without", "AgainstBruteForce",
           EDGES, "(dx * (ey * pz - ez * py) + dy * (ez * px - ex * pz)) + dz * (ex * py - ey * px)",
           "std::fma(dz, ex * py - ey * px, dx * (ey * pz - ez * py) + dy * (ez * px - ex * pz))"),
    mutant("Contraction is allowed", "StyleFloatingPointFlags",
           "cmake/LumitreeCompiler.cmake", ":-ffp-contract=off>", ":-ffp-contract=fast>"),
    mutant("The interval of t without its rounding", "FilterBound Triangles",
           CROSSING, "std::fabs(high)) + 0x1p-1020;\n  double mean", "std::fabs(high)) * 0.0;\n  double mean"),
    mutant("The interval of t a thirtieth as wide as the weights allow", "FilterBound",
           CROSSING, "3.0 * relative * (1.0 + 4.0 * relative) * spread", "0.1 * relative * spread"),
    mutant("The interval of t trusts weights within their error", "FilterBound",
           CROSSING, "if (relative < 1.0 / 12)", "if (true)"),
    mutant("t along x, whatever the direction", "Triangles",
           CROSSING, "const int k = ray.axis;\n  const std::array<double, 3> a = { vertices[0] - ray.origin[k]",
           "const int k = 0;\n  const std::array<double, 3> a = { vertices[0] - ray.origin[k]"),
    mutant("A computed t between the limits is certainly between them", "Triangles Stress",
           CROSSING, "return x.tLow >= ray.tMin && x.tHigh <= ray.tMax;", "return x.t >= ray.tMin && x.t <= ray.tMax;"),
    mutant("A computed t beyond a limit is certainly beyond it", "Triangles Stress",
           CROSSING, "return x.tHigh < ray.tMin || x.tLow > ray.tMax;", "return x.t < ray.tMin || x.t > ray.tMax;"),
]  # fmt: skip

DECISIONS = [
    mutant("Undecided triangles are hits: the exact sign is dropped", "Triangles",
           PRECISIONS, "if (!exact::lineMeetsTriangle(state.ray, vertices))", "if (false)"),
    mutant("Undecided triangles are misses", "Triangles",
           PRECISIONS, "if (!exact::lineMeetsTriangle(state.ray, vertices))", "if (true)"),
    mutant("Watertight takes what is undecided for a miss", "Triangles Watertight",
           PRECISIONS, "return !surelyMissed(own.edges) &&", "return surelyHit(own.edges) &&"),
    mutant("Watertight compares limits with the computed t", "Triangles Stress",
           PRECISIONS, "own.tHigh >= state.ray.tMin &&\n      own.tLow <= state.ray.tMax",
           "own.t >= state.ray.tMin &&\n      own.t <= state.ray.tMax"),
    mutant("Of equal t the highest primitive wins", "Triangles",
           PRECISIONS, "order == 0 && a.primitive < b.primitive", "order == 0 && a.primitive > b.primitive"),
    mutant("t is compared as computed, never exactly", "Triangles Stress",
           PRECISIONS, "const int order = compare(state, a, b);",
           "const int order = a.t < b.t ? -1 : (a.t > b.t ? 1 : 0);"),
    mutant("tMin is compared with the computed t", "Triangles Stress",
           PRECISIONS, "return exact::compareCrossing(state.ray, vertices, limit) >= 0;", "return x.t >= limit;"),
    mutant("< for <= at tMin", "Triangles Stress",
           PRECISIONS, "return exact::compareCrossing(state.ray, vertices, limit) >= 0;",
           "return exact::compareCrossing(state.ray, vertices, limit) > 0;"),
    mutant("< for <= at tMax", "Triangles Stress",
           PRECISIONS, "return exact::compareCrossing(state.ray, vertices, state.ray.tMax) <= 0;",
           "return exact::compareCrossing(state.ray, vertices, state.ray.tMax) < 0;"),
    mutant("< for <= at a triangle's edges", "Triangles",
           FORMULAS, "(u >= 0 && v >= 0 && w >= 0)", "(u > 0 && v > 0 && w > 0)"),
    mutant("The search ends before the upper end of the interval of t", "Stress",
           PRECISIONS, "static double stopAt(const Candidate& c) { return c.tHigh; }",
           "static double stopAt(const Candidate& c) { return 0.999 * c.t; }"),
    mutant("A wide interval of t is not settled exactly", "Triangles Stress",
           FINISH, "tHigh - tLow > 0x1p-26 * std::fabs(t)", "tHigh - tLow > 1e3 * std::fabs(t)"),
    mutant("t may descend along a ray", "Triangles Stress Queries AgainstBruteForce",
           FINISH, "std::max(hit.t, hits.back().t)", "hit.t"),
    mutant("Ties report each its own t", "Queries",
           FINISH, "sameT ? hits.back().t", "sameT ? hit.t"),
    mutant("t is not kept within the segment", "Triangles Stress",
           FINISH, "hit.t = std::min(std::max(hit.t, state.ray.tMin), state.ray.tMax);", ""),
    mutant("Fast orders by t, wherever the ray enters the primitive's box", "AgainstBruteForce Stress",
           PRECISIONS, "c.key = std::max(x.t, tEnter);", "c.key = x.t;"),
    mutant("Fast hits a primitive whose box it does not meet", "AgainstBruteForce Stress",
           PRECISIONS, "return met;", "return true;"),
    mutant("Fast takes a vague t for the key", "AgainstBruteForce",
           PRECISIONS, "x.tHigh - x.tLow <= 0.5 * RayBox::relativePad * std::fabs(x.t)", "true"),
    mutant("Fast: of equal keys the highest primitive wins", "AgainstBruteForce Triangles",
           PRECISIONS, "std::tie(a.key, a.primitive, a.root) < std::tie(b.key, b.primitive, b.root)",
           "std::tie(a.key, b.primitive, a.root) < std::tie(b.key, a.primitive, b.root)"),
    mutant("A primitive found in two leaves counts twice", "Cells Stress",
           QUERIES, "found.erase(std::unique(found.begin(), found.end(),\n"
           "                [](const Candidate& a, const Candidate& b)\n"
           "                { return a.primitive == b.primitive && a.root == b.root; }),\n    found.end());", ""),
    mutant("Ties: only what comes first of equal t", "Queries",
           QUERIES, "if (order <= 0)\n    {\n      state.found.push_back(c);",
           "if (order < 0)\n    {\n      state.found.push_back(c);"),
    mutant("A skip set is read to its first primitive only", "SkipSets",
           "Accel/Kernel/RayState.h", "std::binary_search(this->skipFirst, this->skipLast, id)",
           "(this->skipFirst != this->skipLast && *this->skipFirst == id)"),
    mutant("The host's rounding mode stays", "Numbers",
           "Accel/FloatEnvironment.h", "std::fesetround(FE_TONEAREST);", ""),
    mutant("The host's flushing of subnormals stays", "Numbers",
           "Accel/FloatEnvironment.h", "_mm_setcsr(_mm_getcsr() & ~0x8040u);", ""),
]  # fmt: skip

PASSAGES = [
    mutant("The moved ray: only the first component of the move counts", "Queries",
           FORMULAS, "const int y = x != 0 ? x : a[1].sign();\n  return y != 0 ? y : a[2].sign();", "return x;"),
    mutant("The moved ray: the last component of the move does not count", "Queries",
           FORMULAS, "return y != 0 ? y : a[2].sign();", "return y;"),
    mutant("An edge function of 0 is positive, whichever way the edge runs", "Queries",
           FORMULAS, "return sign != 0 ? sign : firstSign(cross(between<Number>(q, p), d));",
           "return sign != 0 ? sign : 1;"),
    mutant("Crossings counts closed triangles", "Queries",
           PRECISIONS, "!exact::movedLineMeetsTriangle(state.ray, vertices)",
           "!exact::lineMeetsTriangle(state.ray, vertices)"),
    mutant("At a limit the move's direction is turned round", "Queries",
           FORMULAS, "return -firstSign(normal)", "return firstSign(normal)"),
    mutant("A limit is not moved", "Queries",
           PRECISIONS, "exact::compareMovedCrossing(state.ray, vertices, limit) > 0",
           "exact::compareCrossing(state.ray, vertices, limit) > 0"),
]  # fmt: skip

NUMBERS = [
    mutant("The tail of what does not fit the lattice is dropped", "ExactStages ExactPredicates",
           LATTICE, "exact &= truncate(from[k] * this->scale_, to[k]) * this->unit_ == from[k];",
           "truncate(from[k] * this->scale_, to[k]);"),
    mutant("The lattice is two bits too fine: products overflow", "ExactStages ExactPredicates",
           LATTICE, "? 61 : 124", "? 63 : 124"),
    mutant("The wide lattice is two bits too fine", "ExactStages ExactPredicates",
           LATTICE, "? 61 : 124", "? 61 : 126"),
    mutant("A carry between the words of an integer is lost", "ExactStages ExactPredicates",
           FIXED, "carry += static_cast<UInt128>(a.limb(i)) * b.limb(j) + r.limb(i + j);",
           "carry = static_cast<UInt128>(a.limb(i)) * b.limb(j) + r.limb(i + j);"),
    mutant("The borrow of a difference is lost", "ExactStages ExactPredicates",
           FIXED, "const UInt128 d = static_cast<UInt128>(a.limbs_[i]) - b.limbs_[i] - borrow;",
           "const UInt128 d = static_cast<UInt128>(a.limbs_[i]) - b.limbs_[i];"),
    mutant("A negative factor is taken for a large one", "ExactStages ExactPredicates",
           FIXED, "takeOff<M>(r, a, b.negative());", ""),
    mutant("What a quotient cuts off does not count in rounding", "ExactPredicates ExactStages",
           "Accel/Exact/Dyadic.cxx", "leading | (cut ? 1u : 0u)", "leading"),
    mutant("Half is always rounded up", "ExactPredicates ExactStages",
           "Accel/Exact/Dyadic.cxx", "dropped == half && kept % 2 == 1", "dropped == half"),
    mutant("Two t are compared without the signs of their denominators", "ExactPredicates",
           FORMULAS, ".sign() * t0.under.sign() * t1.under.sign();", ".sign() * t0.under.sign();"),
    mutant("Nearly no area is no area", "ExactPredicates Surface",
           PREDICATES, "return collinear<Dyadic>(t);", "return true;"),
]  # fmt: skip

STRUCTURES = [
    mutant("The first leaf with a hit ends the walk of KD- and BSP-trees", "KdTree",
           PLANE_WALK, "tStop = visitor.leaf({ node.first, node.count, current.tEnter });",
           "const double before = tStop;\n"
           "tStop = visitor.leaf({ node.first, node.count, current.tEnter });\n"
           "if (tStop < before)\n{\nreturn;\n}"),
    mutant("A ray in a split plane visits one side", "KdTree",
           PLANE_WALK, "crossing.high < current.tExit ? crossing.high : current.tExit",
           "current.tExit < crossing.high ? current.tExit : crossing.high"),
    mutant("Clipped triangles are not rounded outward", "KdTree",
           "Accel/Structures/KdTreeClip.cxx", "most * 0x1p-49 + 0x1p-1060", "0.0"),
    mutant("A triangle that reaches across a plane is held on one side", "KdTree Cells",
           "Accel/Structures/KdTreeDivision.cxx", "this->addPart(surface, r, KdSide::Above, above);", ""),
    mutant("The same, in a KD-tree that is loaded", "Save",
           "Accel/Structures/KdTreeDivide.cxx", "addPart(r, cells.above, sides.above);", ""),
    mutant("The grid goes to one cell at a time, past those at its corners", "Grid Cells",
           "Accel/Structures/GridSweep.h",
           "first[k] = k == this->fresh_ ? this->axes_[k].last : this->axes_[k].first;",
           "first[k] = this->axes_[k].last;"),
    mutant("The grid's planes are crossed without a pad", "Grid Cells",
           "Accel/Structures/GridSweep.h",
           "return std::fabs(t) * RayBox::relativePad + RayBox::absolutePad;", "return 0.0;"),
    mutant("The first cell with a hit ends the walk of a grid", "Cells Grid",
           "Accel/Structures/Grid.cxx", "} while (sweep.advance(",
           "} while (!(visitor.tStop() < ray.tMax()) && sweep.advance("),
    mutant("The first leaf with a hit ends the walk of an octree", "Cells Octree",
           "Accel/Structures/Octree.cxx",
           "tStop = visitor.leaf({ this->firstBlock_[current.node], node.count, current.tEnter });\n        continue;",
           "const double before = tStop;\n"
           "tStop = visitor.leaf({ this->firstBlock_[current.node], node.count, current.tEnter });\n"
           "if (tStop < before)\n{\nreturn;\n}\ncontinue;"),
    mutant("The BSP-tree's planes are crossed without a pad", "Cells Stress",
           BSP_WALK, "this->low = t - pad;\n      this->high = t + pad;", "this->low = t;\n      this->high = t;"),
    mutant("A ray beside a plane of a BSP-tree visits the far side", "Cells Stress",
           BSP_WALK, "this->nearAbove = start.value > 0.0;", "this->nearAbove = start.value <= 0.0;"),
    mutant("Triangles that touch a cell within rounding are left out", "TriangleBoxOverlap",
           "Accel/Structures/TriangleBoxOverlap.cxx", "relativeError = 0x1p-49", "relativeError = -0x1p-20"),
    mutant("Bounds of spatial splits are not rounded outward", "Save",
           "Accel/Structures/BvhSpatial.cxx", "low - std::fabs(low) * 0x1p-23", "low + std::fabs(low) * 0x1p-23"),
    mutant("Half-spaces of overlap queries allow for no rounding", "Queries",
           "Accel/Kernel/OverlapIndex.cxx", "offset + (0x1p-50 * sum + 0x1p-52 * std::fabs(offset) + floor)", "offset"),
]  # fmt: skip

QUADRICS = [
    mutant("A double root counts twice", "Quadrics",
           "Accel/Exact/QuadraticFormulas.h", "return 1 + this->discriminant().sign();",
           "return this->discriminant().sign() >= 0 ? 2 : 0;"),
    mutant("Of x + y sqrt(d) only x has a sign", "Quadrics",
           "Accel/Exact/QuadraticFormulas.h", "return sx * (x * x - y * y * d).sign();", "return sx;"),
    mutant("Numbers with bounds know no rounding", "Quadrics",
           "Accel/Kernel/Bounded.h", "roundoff = 0x1p-53", "roundoff = 0.0"),
    mutant("A discriminant's sign is taken as computed", "Quadrics",
           "Accel/Kernel/QuadricRoots.cxx", "const Bounded d = b * b - twice(twice(a * c));",
           "const Bounded d = Bounded((b * b - twice(twice(a * c))).value);"),
    mutant("Clip boxes of quadrics are open", "Quadrics",
           "Accel/Exact/QuadraticFormulas.h",
           "signAt(Along::along(ray, k, quadric.clip.upper), root) > 0",
           "signAt(Along::along(ray, k, quadric.clip.upper), root) >= 0"),
]  # fmt: skip

SAVED = [
    mutant("A saved structure is loaded over any surface", "Save",
           "Accel/Save/Save.cxx", "if (!std::equal(of.begin(), of.end(), fingerprint.begin()))", "if (false)"),
    mutant("A saved structure's checksum is not looked at", "Save",
           "Accel/Save/Save.cxx", "require(checksum.get<std::uint32_t>() == checksumOf(header, body)", "require(true"),
    mutant("A saved structure may end early", "Save",
           "Accel/Save/SaveStream.h", "if (count > this->bytes_.size() / size)", "if (false)"),
    mutant("A saved node may have two parents", "Save",
           "Accel/Structures/BvhSave.cxx", "&& !taken[first] && !taken[first + 1]", ""),
    mutant("A saved tree may be of any depth", "Save",
           "Accel/Structures/BvhSave.cxx", "require(depths[i] < depthLimit,", "require(true,"),
    mutant("Of a refitted tree the boxes are those of each leaf's first primitive", "Save",
           "Accel/Structures/BvhLeaves.cxx", "i < firsts[leaf + 1]; ++i)\n        {\n          box.extend",
           "i < firsts[leaf] + 1; ++i)\n        {\n          box.extend"),
]  # fmt: skip

MUTANTS = NUMBERS + WIDE_BVH + BUNDLES + STRUCTURES + PASSAGES + BOXES + DECISIONS + SAVED + QUADRICS + LEAF
