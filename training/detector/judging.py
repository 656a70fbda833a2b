# SPDX-License-Identifier: MIT
"""What a network finds in pictures that it has not learned from."""
import numpy
import torch

from objective import boxes_of
from pictures import CLASS, H, U, UNCLEAR, VALID

THRESHOLDS = (0.3, 0.5, 0.7)


def overlaps(box, others):
    """Intersections over union of one box with others."""
    low = numpy.maximum(box[:2] - box[2:] / 2, others[:, :2] - others[:, 2:] / 2)
    high = numpy.minimum(box[:2] + box[2:] / 2, others[:, :2] + others[:, 2:] / 2)
    shared = (high - low).clip(0.0).prod(1)
    return shared / numpy.maximum(box[2:].prod() + others[:, 2:].prod(1) - shared, 1e-3)


def detections(cells, threshold):
    """Per picture: score, colour, box (u, v, w, h) after suppression of repeats; best first."""
    scores = torch.sigmoid(cells[:, 0]).cpu().numpy()
    boxes, colors = boxes_of(cells).cpu().numpy(), cells[:, 5:].argmax(1).cpu().numpy()
    result = []
    for i, score in enumerate(scores):
        rows, columns = (score > threshold).nonzero()
        kept = []
        for k in (-score[rows, columns]).argsort(kind="stable"):
            at = (i, rows[k], columns[k])
            if not kept or overlaps(boxes[at], numpy.array([one[2] for one in kept])).max() < 0.45:
                kept.append((float(scores[at]), int(colors[at]), boxes[at]))
        result.append(kept)
    return result


def count_picture(found, labels, threshold, counts):
    """Adds found, of the right class, false and wanted ones of one picture."""
    taken = set()
    for score, color, box in found:
        if score < threshold:
            continue
        ious = overlaps(box, labels[:, U:H + 1]) if len(labels) else numpy.zeros(1)
        best = int(ious.argmax())
        if ious[best] >= 0.5 and best not in taken:
            taken.add(best)
            if not labels[best, UNCLEAR]:
                counts[0] += 1
                counts[1] += int(labels[best, CLASS]) == color
        elif ious[best] < 0.3 or not labels[best, UNCLEAR]:
            counts[2] += 1
    counts[3] += int((labels[:, UNCLEAR] == 0).sum())


def judge(network, pictures):
    """Prints recall and precision of any class, and the share of right classes."""
    network.eval()
    tally = {threshold: [0, 0, 0, 0] for threshold in THRESHOLDS}
    for start in range(0, len(pictures), 16):
        with torch.no_grad():
            x = pictures.pixels[start:start + 16].permute(0, 3, 1, 2).float() / 128.0 - 1.0
            cells = network(x)
        labels = pictures.labels[start:start + 16].cpu().numpy()
        for found, of_one in zip(detections(cells, min(THRESHOLDS)), labels):
            for threshold, counts in tally.items():
                count_picture(found, of_one[of_one[:, VALID] > 0.5], threshold, counts)
    for threshold, (found, right, false, wanted) in tally.items():
        print(f"    at {threshold:.2f}: recall {found / max(1, wanted):.3f} precision "
              f"{found / max(1, found + false):.3f} class {right / max(1, found):.3f}", flush=True)
