#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Trains the detector network from scratch on pictures of training_frames.

    train.py --out FILE.onnx [--steps N] [--seed S] --held-out FOLDER... -- FOLDER...

Needs Debian's python3-torch and python3-numpy. README.md has the recipe that made the weights here.
"""
import argparse
import csv
import os
import queue
import threading
import time

import numpy
import torch
from torch.nn import functional

from network import COLORS, SIZE_UNIT, STRIDE, Network, export

HEIGHT, WIDTH = 240, 320
BATCH = 8  # whole pictures; as many more crops as have the same number of pixels


class Pictures:
    """Pictures of some folders, and their labels: class, u, v, w, h, unclear."""

    def __init__(self, folders):
        self.pixels, self.labels = [], []
        for folder in folders:
            data = numpy.memmap(os.path.join(folder, "pixels.bin"), numpy.uint8, "r")
            data = data.reshape(-1, HEIGHT, WIDTH, 3)
            labels = [[] for _ in range(len(data))]
            with open(os.path.join(folder, "labels.csv"), encoding="ascii") as table:
                for row in csv.DictReader(table):
                    labels[int(row["frame"])].append(
                        [COLORS.index(row["class"])] + [float(row[k]) for k in "uvwh"]
                        + [float(row["unclear"])])
            self.pixels.extend(data)
            self.labels.extend(numpy.array(one, dtype=numpy.float32).reshape(-1, 6)
                               for one in labels)

    def __len__(self):
        return len(self.pixels)


def cut(labels, left, top, width, height):
    """Labels in a crop; what loses too much of itself becomes unclear."""
    made = []
    for color, u, v, w, h, unclear in labels:
        first_u, last_u = max(u - w / 2 - left, 0.0), min(u + w / 2 - left, width)
        first_v, last_v = max(v - h / 2 - top, 0.0), min(v + h / 2 - top, height)
        if last_u - first_u < 1.0 or last_v - first_v < 1.0:
            continue
        shown = (last_u - first_u) * (last_v - first_v) / (w * h)
        made.append([color, (first_u + last_u) / 2, (first_v + last_v) / 2, last_u - first_u,
                     last_v - first_v, 1.0 if unclear or shown < 0.4 else 0.0])
    return made


def draw_batch(pictures, random, whole):
    """Pictures or crops of them, one magnification per batch, mirrored, recoloured."""
    height, width = (HEIGHT, WIDTH) if whole else (128, 160)
    count = BATCH if whole else 3 * BATCH
    scale = 1.0 if whole else float(random.choice([0.8, 1.0, 1.25, 1.6]))
    take_h, take_w = min(HEIGHT, round(height * scale)), min(WIDTH, round(width * scale))
    images = numpy.empty((count, take_h, take_w, 3), numpy.float32)
    all_labels = []
    for i in range(count):
        index = random.integers(len(pictures))
        labels = pictures.labels[index]
        top = random.integers(HEIGHT - take_h + 1)
        left = random.integers(WIDTH - take_w + 1)
        if not whole and len(labels) and random.random() < 0.7:  # most of a picture is empty
            _, u, v, _, _, _ = labels[random.integers(len(labels))]
            left = int(numpy.clip(u - take_w * random.uniform(0.1, 0.9), 0, WIDTH - take_w))
            top = int(numpy.clip(v - take_h * random.uniform(0.1, 0.9), 0, HEIGHT - take_h))
        image = pictures.pixels[index][top:top + take_h, left:left + take_w].astype(numpy.float32)
        kept = cut(labels, left, top, take_w, take_h)
        if random.random() < 0.5:
            image = image[:, ::-1]
            kept = [[c, take_w - u, v, w, h, x] for c, u, v, w, h, x in kept]
        if random.random() < 0.25:
            image = image[::-1]
            kept = [[c, u, take_h - v, w, h, x] for c, u, v, w, h, x in kept]
        if random.random() < 0.5:
            gain = numpy.exp(random.normal(0.0, 0.12, 3)) * numpy.exp(random.normal(0.0, 0.2))
            image = image * gain.astype(numpy.float32) + numpy.float32(random.normal(0.0, 10.0))
        if random.random() < 0.3:
            image = image + random.normal(0.0, random.uniform(1.0, 8.0),
                                          image.shape).astype(numpy.float32)
        images[i] = image
        all_labels.append(numpy.array(kept, numpy.float32).reshape(-1, 6))
    x = torch.from_numpy(images).clamp_(0.0, 255.0).permute(0, 3, 1, 2).contiguous()
    if (take_h, take_w) != (height, width):
        x = functional.interpolate(x, (height, width), mode="bilinear", align_corners=False)
        for labels in all_labels:
            labels[:, [1, 3]] *= width / take_w
            labels[:, [2, 4]] *= height / take_h
    return x / 128.0 - 1.0, all_labels


def batches(pictures, random, steps):
    """All batches, one after the other, each drawn while the one before is learned from."""
    waiting = queue.Queue(maxsize=3)

    def draw():
        for step in range(1, steps + 1):
            waiting.put(draw_batch(pictures, random, whole=step % 4 == 0))

    threading.Thread(target=draw, daemon=True).start()
    for step in range(1, steps + 1):
        yield step, *waiting.get()


def targets(all_labels, rows, columns):
    """Per cell: 1 object, 0 none, -1 not asked; its box, its colour, how much it counts."""
    count = len(all_labels)
    state = numpy.zeros((count, rows, columns), numpy.float32)
    box = numpy.zeros((count, rows, columns, 4), numpy.float32)
    color = numpy.zeros((count, rows, columns), numpy.int64)
    weight = numpy.ones((count, rows, columns), numpy.float32)
    v, u = numpy.meshgrid((numpy.arange(rows) + 0.5) * STRIDE,
                          (numpy.arange(columns) + 0.5) * STRIDE, indexing="ij")
    for i, labels in enumerate(all_labels):
        # Small ones last: what lies before something large is theirs.
        for c, bu, bv, w, h, unclear in sorted(labels.tolist(), key=lambda one: -one[3] * one[4]):
            inside = (abs(u - bu) < w / 2 + STRIDE / 2) & (abs(v - bv) < h / 2 + STRIDE / 2)
            if unclear:
                state[i][inside & (state[i] < 1.0)] = -1.0
                continue
            # Cells around the middle are to find it; those farther out may.
            core = ((abs(u - bu) <= numpy.clip(0.18 * w, STRIDE / 2, 1.5 * STRIDE))
                    & (abs(v - bv) <= numpy.clip(0.18 * h, STRIDE / 2, 1.5 * STRIDE)))
            near = ((abs(u - bu) <= max(STRIDE * 0.9, 0.32 * w))
                    & (abs(v - bv) <= max(STRIDE * 0.9, 0.32 * h)))
            state[i][near & (state[i] < 1.0)] = -1.0
            state[i][core] = 1.0
            box[i][core] = (bu, bv, w, h)
            color[i][core] = int(c)
            weight[i][core] = core.sum() ** -0.5  # many cells of a large object count for few
    return [torch.from_numpy(array) for array in (state, box, color, weight)]


def boxes_of(cells):
    """u, v, w, h in pixels of every cell: count x rows x columns x 4."""
    rows, columns = cells.shape[2:]
    v = (torch.arange(rows) + 0.5)[None, :, None]
    u = (torch.arange(columns) + 0.5)[None, None, :]
    return torch.stack([(u + cells[:, 1]) * STRIDE, (v + cells[:, 2]) * STRIDE,
                        SIZE_UNIT * torch.exp(cells[:, 3].clamp(-4.0, 4.0)),
                        SIZE_UNIT * torch.exp(cells[:, 4].clamp(-4.0, 4.0))], -1)


def overlap(one, other):
    """Intersection over union, and the same less what neither covers of the hull (GIoU)."""
    low = torch.maximum(one[..., :2] - one[..., 2:] / 2, other[..., :2] - other[..., 2:] / 2)
    high = torch.minimum(one[..., :2] + one[..., 2:] / 2, other[..., :2] + other[..., 2:] / 2)
    shared = (high - low).clamp(min=0.0).prod(-1)
    union = one[..., 2:].prod(-1) + other[..., 2:].prod(-1) - shared
    hull_low = torch.minimum(one[..., :2] - one[..., 2:] / 2, other[..., :2] - other[..., 2:] / 2)
    hull_high = torch.maximum(one[..., :2] + one[..., 2:] / 2, other[..., :2] + other[..., 2:] / 2)
    hull = (hull_high - hull_low).prod(-1)
    iou = shared / union.clamp(min=1e-3)
    return iou, iou - (hull - union) / hull.clamp(min=1e-3)


def loss_of(cells, all_labels):
    state, box, color, weight = targets(all_labels, *cells.shape[2:])
    found = state > 0.5
    counts = weight[found]
    total = counts.sum().clamp(min=1.0)
    iou, giou = overlap(boxes_of(cells)[found], box[found])
    # GIoU alone starts slowly where boxes are a cell or two wide.
    made, asked = boxes_of(cells)[found], box[found]
    offset = (made[:, :2] - asked[:, :2]) / asked[:, 2:].clamp(min=STRIDE)
    size = torch.log(made[:, 2:] / asked[:, 2:])
    misfit = functional.smooth_l1_loss(torch.cat([offset, size], 1), torch.zeros(len(made), 4),
                                       beta=0.05, reduction="none").sum(1)
    # The score is to say how well the box fits [Li 2020, quality focal loss].
    wanted = torch.zeros_like(state)
    wanted[found] = iou.detach().clamp(0.0, 1.0)
    score = torch.sigmoid(cells[:, 0])
    focus = (wanted - score).detach().abs().pow(1.5) * (state > -0.5) * weight
    objectness = (focus * functional.binary_cross_entropy_with_logits(
        cells[:, 0], wanted, reduction="none")).sum() / total
    fit = (counts * (1.0 - giou + misfit)).sum() / total
    classes = (counts * functional.cross_entropy(cells.permute(0, 2, 3, 1)[found][:, 5:],
                                                 color[found], reduction="none")).sum() / total
    return objectness, fit, classes


def detections(cells, threshold, with_logits=False):
    """Per picture: score, colour, box (u, v, w, h) after suppression of repeats; logits of colour."""
    scores = torch.sigmoid(cells[:, 0])
    boxes, colors = boxes_of(cells), cells[:, 5:].argmax(1)
    result = []
    for i in range(len(cells)):
        chosen = (scores[i] > threshold).nonzero()
        order = scores[i][chosen[:, 0], chosen[:, 1]].argsort(descending=True)
        kept = []
        for row, column in chosen[order].tolist():
            box = boxes[i, row, column]
            if all(float(overlap(box, other[2])[0]) < 0.45 for other in kept):
                kept.append((float(scores[i, row, column]), int(colors[i, row, column]), box)
                            + ((cells[i, 5:, row, column],) if with_logits else ()))
        result.append(kept)
    return result


def judge(network, pictures, thresholds):
    """Prints recall and precision of any class, and the share of right classes."""
    network.eval()
    tally = {t: [0, 0, 0, 0] for t in thresholds}  # found, right class, false, wanted
    with torch.no_grad():
        for start in range(0, len(pictures), 16):
            count = min(16, len(pictures) - start)
            x = torch.from_numpy(numpy.stack(pictures.pixels[start:start + count])).float()
            cells = network(x.permute(0, 3, 1, 2) / 128.0 - 1.0)
            for i, all_found in enumerate(detections(cells, min(thresholds))):
                labels = pictures.labels[start + i]
                for threshold, counts in tally.items():
                    taken = set()
                    for score, color, box in all_found:
                        if score < threshold:
                            continue
                        ious = [float(overlap(box, torch.from_numpy(label[1:5]))[0])
                                for label in labels]
                        best = int(numpy.argmax(ious)) if ious else -1
                        if best >= 0 and ious[best] >= 0.5 and best not in taken:
                            taken.add(best)
                            if not labels[best][5]:
                                counts[0] += 1
                                counts[1] += int(labels[best][0]) == color
                        elif best < 0 or ious[best] < 0.3 or not labels[best][5]:
                            counts[2] += 1
                    counts[3] += sum(1 for label in labels if not label[5])
    for threshold, (found, right, false, wanted) in tally.items():
        print(f"    at {threshold:.2f}: recall {found / max(1, wanted):.3f} precision "
              f"{found / max(1, found + false):.3f} class {right / max(1, found):.3f}", flush=True)
    network.train()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--out", required=True)
    parser.add_argument("--steps", type=int, default=6000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--held-out", nargs="+", default=[])
    parser.add_argument("folders", nargs="+")
    given = parser.parse_args()
    torch.set_num_threads(given.threads)
    torch.manual_seed(given.seed)
    random = numpy.random.default_rng(given.seed)
    pictures = Pictures(given.folders)
    held_out = [(folder, Pictures([folder])) for folder in given.held_out]
    network = Network()
    average = Network()  # of the weights over the last few hundred steps: steadier than any of them
    average.load_state_dict(network.state_dict())
    optimizer = torch.optim.AdamW(network.parameters(), lr=3e-3, weight_decay=1e-3)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, 3e-3, given.steps, pct_start=0.1)
    start, sums = time.time(), numpy.zeros(3)
    for step, x, labels in batches(pictures, random, given.steps):
        losses = loss_of(network(x), labels)
        optimizer.zero_grad()
        (losses[0] + losses[1] + 0.7 * losses[2]).backward()
        torch.nn.utils.clip_grad_norm_(network.parameters(), 5.0)
        optimizer.step()
        schedule.step()
        sums += [float(loss) for loss in losses]
        with torch.no_grad():
            keep = min(0.998, step / (step + 50.0))
            for mine, its in zip(average.state_dict().values(), network.state_dict().values()):
                if mine.dtype.is_floating_point:
                    mine.lerp_(its, 1.0 - keep)
        if step % 200 == 0:
            print(f"{step} of {given.steps}, {time.time() - start:.0f} s: object {sums[0] / 200:.3f}"
                  f" box {sums[1] / 200:.3f} class {sums[2] / 200:.3f}", flush=True)
            sums[:] = 0.0
        if step % 2000 == 0 or step == given.steps:
            for folder, some in held_out:
                print(f"  {folder}")
                judge(average, some, (0.3, 0.4, 0.5, 0.6))
            torch.save(average.state_dict(), given.out + ".pt")
    export(average, given.out)


if __name__ == "__main__":
    main()
