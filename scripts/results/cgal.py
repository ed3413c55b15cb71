"""The peer of the standing table that anyone can run: CGAL's efficient RANSAC (Schnabel, Wahl and Klein 2007).

    python3 -m venv venv && venv/bin/pip install cgal==6.0.1.post202410241521 numpy
    venv/bin/python scripts/results/cgal.py CLOUDS --out found > times.json
    npx fit4cad submit CLOUDS found --set test-10 --times times.json --to results/cgal-ransac

CLOUDS is a folder, or the zip of one, with the benchmark's clouds PC1.txt, PC2.txt and so on. What is found goes to
found/CGAL as a label for each point, to which fit4cad fits surfaces. Printed is the processor time of each cloud, one thread:
normals and detection, without reading and writing.

All parameters are CGAL's own defaults: shapes of at least 1 % of the points, a distance and a gap of at most 1 % of the
diagonal of the bounding box, normals within acos 0.9, a probability of 1 % to miss the largest shape. With --spacing
lengths follow the cloud instead: shapes of at least 10 points, a distance of a quarter of the median distance between
nearest neighbours, a gap of two and a half; on ten training models a tenth of the spacing and a gap of two came to the
same. Normals, which the method needs, are CGAL's jets of 16 neighbours. CGAL draws its random numbers from a seed that
it does not let be set from Python: another run finds a little else.
"""

import argparse
import io
import json
import os
import re
import sys
import time
import zipfile

import numpy
from CGAL.CGAL_Kernel import Point_3
from CGAL.CGAL_Point_set_3 import Point_set_3
from CGAL.CGAL_Point_set_processing_3 import jet_estimate_normals
from CGAL.CGAL_Shape_detection import efficient_RANSAC

CLOUD = re.compile(r"(?:^|/)(PC[0-9]+)\.txt$")
ROW = re.compile(r"\[\s*([^,\[\]]+),\s*([^,\[\]]+),\s*([^,\[\]]+)\]")


def clouds(path):
    """The clouds below a path, as pairs of name and text."""
    if os.path.isfile(path):
        with zipfile.ZipFile(path) as archive:
            for name in sorted(archive.namelist()):
                if match := CLOUD.search(name):
                    yield match[1], io.TextIOWrapper(archive.open(name), "utf-8").read()
        return
    for folder, _, names in sorted(os.walk(path)):
        for name in sorted(names):
            if match := CLOUD.search(name):
                with open(os.path.join(folder, name), encoding="utf-8") as file:
                    yield match[1], file.read()


def diagonal(points):
    """Of the axis-aligned box around the points."""
    return sum((max(axis) - min(axis)) ** 2 for axis in zip(*points)) ** 0.5


def spacing(points):
    """The median distance of a point to the nearest other place, of at most 300 of the points."""
    places = numpy.unique(numpy.array(points), axis=0)
    some = places[numpy.linspace(0, len(places) - 1, min(300, len(places))).astype(int)]
    return float(numpy.median([numpy.sqrt(numpy.partition(((places - each) ** 2).sum(1), 1)[1]) for each in some]))


def detect(points, by_spacing):
    """The shape of each point, -1 for none."""
    cloud = Point_set_3()
    for x, y, z in points:
        cloud.insert(Point_3(x, y, z))
    cloud.add_normal_map()
    jet_estimate_normals(cloud, 16)
    shape = cloud.add_int_map("shape", -1)
    if by_spacing:
        size = spacing(points)
        least, distance, gap = 10, 0.25 * size, 2.5 * size
    else:
        size = diagonal(points)
        least, distance, gap = max(1, len(points) // 100), 0.01 * size, 0.01 * size
    efficient_RANSAC(cloud, shape, least, distance, gap, 0.9, 0.01, True, True, True, True, True)
    # The detection leaves the range of indices in another order; each index keeps its point.
    return [shape.get(index) for index in range(len(points))]


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("clouds", help="folder or zip")
    arguments.add_argument("--spacing", action="store_true", help="lengths follow the spacing of the cloud")
    arguments.add_argument("--out", required=True, help="folder of what is found")
    given = arguments.parse_args()
    folder = os.path.join(given.out, "CGAL")
    os.makedirs(folder, exist_ok=True)
    times = []
    for name, text in clouds(given.clouds):
        points = [tuple(map(float, row)) for row in ROW.findall(text)]
        start = time.process_time()
        found = detect(points, given.spacing)
        seconds = time.process_time() - start
        shapes = len(set(found) - {-1})
        times.append({"model": name, "points": len(points), "seconds": seconds, "primitives": shapes})
        print(f"{name}: {len(points)} points, {shapes} shapes, {seconds:.2f} s", file=sys.stderr)
        with open(os.path.join(folder, f"{name}.labels"), "w", encoding="utf-8") as file:
            file.write("".join(f"{label}\n" for label in found))
    json.dump(times, sys.stdout, indent=1)
    print()


if __name__ == "__main__":
    main()
