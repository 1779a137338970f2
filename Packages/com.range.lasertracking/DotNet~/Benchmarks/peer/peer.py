#!/usr/bin/env python3
"""The published detectors written with OpenCV, timed on the frames that `range bench --peer` rendered. See README.md.

usage: peer.py FOLDER      prints JSON
"""

import json
import os
import sys
import time

import cv2
import numpy as np

ALPHA, GAMMA, SPIKE, GREEN, TOP, LEAST_EXCESS = 0.95, 0.88, 0.6, 0.4, 0.005, 25
WIDTH = 960
BOARD = (9, 6)
WARM_UP_S, MEASURED_S, LEAST_RUNS = 0.5, 3.0, 50


class PaperFloat:
    """The description line by line, in 32-bit floats."""

    def __init__(self, to_bgr):
        self.to_bgr, self.background, self.spike = to_bgr, None, None

    def __call__(self, frame):
        bgr = self.to_bgr(frame)
        height = round(bgr.shape[0] * WIDTH / bgr.shape[1])
        small = cv2.resize(bgr, (WIDTH, height), interpolation=cv2.INTER_AREA).astype(np.float32)
        gray = cv2.cvtColor(small, cv2.COLOR_BGR2GRAY)
        if self.background is None:
            self.background, self.spike = gray.copy(), np.zeros_like(gray)
        difference = cv2.GaussianBlur(np.abs(gray - self.background), (3, 3), 0)
        self.background = ALPHA * self.background + (1 - ALPHA) * gray
        self.spike = np.maximum(difference, GAMMA * self.spike)
        blue, green, red = cv2.split(small)
        excess = cv2.GaussianBlur(np.maximum(green - 0.5 * (red + blue), 0), (3, 3), 0)
        score = SPIKE * self.spike + GREEN * excess
        threshold = np.percentile(score, 100 * (1 - TOP))
        mask = ((score >= threshold) & (excess >= LEAST_EXCESS)).astype(np.uint8)
        _, best, _, at = cv2.minMaxLoc(score, mask)
        return [at] if best > 0 else []


class PaperTuned:
    """The same in 8 bits wherever that will do, in place, without a temporary that can be spared."""

    def __init__(self, to_bgr):
        self.to_bgr, self.background = to_bgr, None

    def __call__(self, frame):
        bgr = self.to_bgr(frame)
        height = round(bgr.shape[0] * WIDTH / bgr.shape[1])
        exact = bgr.shape[1] == 2 * WIDTH
        small = cv2.resize(bgr, (WIDTH, height), interpolation=cv2.INTER_AREA if exact else cv2.INTER_LINEAR)
        gray = cv2.cvtColor(small, cv2.COLOR_BGRA2GRAY if small.shape[2] == 4 else cv2.COLOR_BGR2GRAY)
        if self.background is None:
            self.background, self.spike = gray.astype(np.float32), np.zeros_like(gray)
            self.before, self.difference, self.half = np.empty_like(gray), np.empty_like(gray), np.empty_like(gray)
            self.blue, self.green, self.red = np.empty_like(gray), np.empty_like(gray), np.empty_like(gray)
            self.score, self.top, self.mask = np.empty_like(gray), np.empty_like(gray), np.empty_like(gray)
        cv2.convertScaleAbs(self.background, self.before)
        cv2.absdiff(gray, self.before, self.difference)
        cv2.accumulateWeighted(gray, self.background, 1 - ALPHA)
        cv2.GaussianBlur(self.difference, (3, 3), 0, self.difference)
        cv2.convertScaleAbs(self.spike, self.half, GAMMA)
        cv2.max(self.difference, self.half, self.spike)
        cv2.extractChannel(small, 0, self.blue)
        cv2.extractChannel(small, 1, self.green)
        cv2.extractChannel(small, 2, self.red)
        cv2.addWeighted(self.red, 0.5, self.blue, 0.5, 0, self.red)
        cv2.subtract(self.green, self.red, self.green)
        cv2.GaussianBlur(self.green, (3, 3), 0, self.green)
        cv2.addWeighted(self.spike, SPIKE, self.green, GREEN, 0, self.score)
        histogram = cv2.calcHist([self.score], [0], None, [256], [0, 256]).ravel()
        above = np.cumsum(histogram[::-1])[::-1]
        threshold = int(np.flatnonzero(above >= TOP * gray.size)[-1])
        cv2.compare(self.score, threshold, cv2.CMP_GE, self.top)
        cv2.compare(self.green, LEAST_EXCESS, cv2.CMP_GE, self.mask)
        cv2.bitwise_and(self.mask, self.top, self.mask)
        _, best, _, at = cv2.minMaxLoc(self.score, self.mask)
        return [at] if best > 0 else []


def is_spot(area):
    return 2 <= area <= 400


def bright_limit(sample):
    """Median plus what neither texture nor noise reaches: robust, from the values given."""
    level = float(np.median(sample))
    spread = 1.4826 * float(np.median(np.abs(sample.astype(np.float32) - level)))
    return level, level + max(20.0, 0.3 * level, 8 * spread)


def dual_naive(infrared, bgra):
    """Both pictures whole: threshold and label infrared, HSV range and label colour, match the two."""
    blurred = cv2.GaussianBlur(infrared, (3, 3), 0)
    bright = (blurred > bright_limit(infrared[::8, ::8])[1]).astype(np.uint8)
    count, _, stats, centers = cv2.connectedComponentsWithStats(bright)
    hsv = cv2.cvtColor(cv2.cvtColor(bgra, cv2.COLOR_BGRA2BGR), cv2.COLOR_BGR2HSV)
    green = cv2.inRange(hsv, (35, 40, 60), (90, 255, 255))
    cv2.connectedComponentsWithStats(green)
    found = []
    for i in range(1, count):
        if is_spot(stats[i, cv2.CC_STAT_AREA]):
            x, y = centers[i][0] * bgra.shape[1] / infrared.shape[1], centers[i][1] * bgra.shape[0] / infrared.shape[0]
            found.append((x, y, bool(green[max(0, int(y) - 20):int(y) + 21, max(0, int(x) - 20):int(x) + 21].any())))
    return found


def dual_region(infrared, bgra):
    """Infrared first, no labelling, colour only around its few candidates."""
    level, limit = bright_limit(infrared[::8, ::8])
    bright = cv2.compare(infrared, limit, cv2.CMP_GT)
    points = cv2.findNonZero(bright)
    found = []
    if points is None or len(points) > 20000:
        return found
    points = points[:, 0, :]
    scale_x, scale_y = bgra.shape[1] / infrared.shape[1], bgra.shape[0] / infrared.shape[0]
    while len(points):
        near = (np.abs(points - points[0]) <= 12).all(axis=1)
        group, points = points[near], points[~near]
        if not is_spot(len(group)):
            continue
        weights = infrared[group[:, 1], group[:, 0]].astype(np.float64) - level
        x, y = (group * weights[:, None]).sum(axis=0) / weights.sum() * (scale_x, scale_y)
        region = bgra[max(0, int(y) - 20):int(y) + 21, max(0, int(x) - 20):int(x) + 21]
        if region.size == 0:
            continue
        hsv = cv2.cvtColor(cv2.cvtColor(region, cv2.COLOR_BGRA2BGR), cv2.COLOR_BGR2HSV)
        found.append((x, y, cv2.countNonZero(cv2.inRange(hsv, (35, 40, 60), (90, 255, 255))) > 0))
    return found


def board_classic(gray):
    """Quadrangles, then sub-pixel corners with the window of the reference calibration."""
    found, corners = cv2.findChessboardCorners(gray, BOARD, flags=cv2.CALIB_CB_ADAPTIVE_THRESH | cv2.CALIB_CB_NORMALIZE_IMAGE)
    if found:
        cv2.cornerSubPix(gray, corners, (5, 5), (-1, -1), (cv2.TERM_CRITERIA_EPS | cv2.TERM_CRITERIA_COUNT, 30, 0.01))
    return corners if found else []


def board_sector(gray):
    """Duda and Frese's sectors, which the library calls SB; sub-pixel by itself."""
    found, corners = cv2.findChessboardCornersSB(gray, BOARD)
    return corners if found else []


def measure(operation, frames):
    """As the benchmark does: there and back through the frames, warm first, each call timed."""
    order = list(range(len(frames))) + list(range(len(frames) - 2, 0, -1))
    number, found, times = 0, 0, []
    end = time.perf_counter() + WARM_UP_S
    while time.perf_counter() < end or number < 2 * len(order):
        operation(frames[order[number % len(order)]])
        number += 1
    end = time.perf_counter() + MEASURED_S
    while time.perf_counter() < end or len(times) < LEAST_RUNS:
        start = time.perf_counter()
        result = operation(frames[order[number % len(order)]])
        times.append(1000 * (time.perf_counter() - start))
        found += len(result)
        number += 1
    times.sort()
    return {"iterations": len(times), "median_ms": times[len(times) // 2], "p95_ms": times[int(0.95 * (len(times) - 1))], "found_per_frame": found / len(times)}


def read(folder, entry):
    data = np.fromfile(os.path.join(folder, entry["file"]), dtype=np.dtype(entry["type"]))
    return list(data.reshape(entry["shape"]))


def calibrate_stereo(corners):
    """Each camera alone, then how they stand to each other with the cameras held."""
    points = np.array([[x, y, 0] for x, y in corners["object_points_mm"]], np.float32)
    size, end = tuple(corners["image_size"]), (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 200, 1e-9)
    board = [points] * len(corners["pairs"])
    left, right = ([np.array(pair[side], np.float32).reshape(-1, 1, 2) for pair in corners["pairs"]] for side in ("left_px", "right_px"))
    _, left_matrix, left_dist, _, _ = cv2.calibrateCamera(board, left, size, None, None, criteria=end)
    _, right_matrix, right_dist, _, _ = cv2.calibrateCamera(board, right, size, None, None, criteria=end)
    cv2.stereoCalibrate(board, left, right, left_matrix, left_dist, right_matrix, right_dist, size, flags=cv2.CALIB_FIX_INTRINSIC, criteria=end)
    return []


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    cv2.setNumThreads(1)
    folder = sys.argv[1]
    with open(os.path.join(folder, "frames.json"), encoding="utf-8") as file:
        listed = json.load(file)
    bgra, nv12, infrared, color, boards = (read(folder, listed[name]) for name in ("bgra", "nv12", "dual_infrared", "dual_bgra", "board"))
    pairs = list(zip(infrared, color))
    pixels = read(folder, listed["lens"])
    fx, fy, cx, cy = listed["lens"]["K"]
    matrix, dist = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]]), np.array(listed["lens"]["dist"])
    converged = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 100, 1e-9)
    with open(os.path.join(folder, "corners.json")) as file:
        corners = [json.load(file)]
    as_it_is = lambda frame: frame
    from_bgra = lambda frame: cv2.cvtColor(frame, cv2.COLOR_BGRA2BGR)
    from_nv12 = lambda frame: cv2.cvtColor(frame, cv2.COLOR_YUV2BGR_NV12)
    cases = [
        ("paper-1080p", "float", PaperFloat(from_bgra), bgra, ["detect-1080p", "paper-1080p"]),
        ("paper-1080p", "8-bit", PaperTuned(as_it_is), bgra, ["detect-1080p", "paper-1080p"]),
        ("paper-720p-nv12", "float", PaperFloat(from_nv12), nv12, ["detect-720p-nv12"]),
        ("paper-720p-nv12", "8-bit", PaperTuned(from_nv12), nv12, ["detect-720p-nv12"]),
        ("dual-1080p", "naive", lambda pair: dual_naive(*pair), pairs, ["dual-1080p", "dual-infrared-1080p"]),
        ("dual-1080p", "region", lambda pair: dual_region(*pair), pairs, ["dual-1080p", "dual-infrared-1080p"]),
        ("undistortPoints", "5 iterations", lambda points: cv2.undistortPoints(points, matrix, dist), pixels, ["lens-lookup", "lens-exact"]),
        ("undistortPoints", "converged", lambda points: cv2.undistortPointsIter(points, matrix, dist, None, None, converged), pixels, ["lens-lookup", "lens-exact"]),
        ("calibrate-stereo", "calibrateCamera twice, stereoCalibrate", calibrate_stereo, corners, ["calibrate-stereo"]),
        ("board-1080p", "findChessboardCorners", board_classic, boards, ["board-1080p"]),
        ("board-1080p", "findChessboardCornersSB", board_sector, boards, ["board-1080p"]),
    ]
    results = [dict(name=name, variant=variant, compare=compare, **measure(operation, frames)) for name, variant, operation, frames, compare in cases]
    print(json.dumps({"opencv": cv2.__version__, "threads": 1, "results": results}))
    return 0


if __name__ == "__main__":
    sys.exit(main())
