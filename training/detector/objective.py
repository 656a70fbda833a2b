# SPDX-License-Identifier: MIT
"""What the network is to say of a batch, and how far it is from that."""
import torch
from torch.nn import functional

from network import SIZE_UNIT, STRIDE
from pictures import CLASS, H, U, UNCLEAR, V, VALID, W


def targets(labels, rows, columns):
    """Per cell: 1 object, 0 none, -1 not asked; its box, its colour, how much it counts."""
    v = ((torch.arange(rows, device=labels.device) + 0.5) * STRIDE)[:, None]
    u = (torch.arange(columns, device=labels.device) + 0.5) * STRIDE
    each = labels[..., None, None]
    w, h = each[:, :, W], each[:, :, H]
    across, down = (u - each[:, :, U]).abs(), (v - each[:, :, V]).abs()
    is_valid, is_unclear = each[:, :, VALID] > 0.5, each[:, :, UNCLEAR] > 0.5
    # Cells around the middle are to find it; those farther out may.
    core = ((across <= (0.18 * w).clamp(STRIDE / 2, 1.5 * STRIDE))
            & (down <= (0.18 * h).clamp(STRIDE / 2, 1.5 * STRIDE)) & is_valid & ~is_unclear)
    near = ((across <= (0.32 * w).clamp(min=0.9 * STRIDE))
            & (down <= (0.32 * h).clamp(min=0.9 * STRIDE)) & is_valid & ~is_unclear)
    inside = ((across < w / 2 + STRIDE / 2) & (down < h / 2 + STRIDE / 2) & is_valid & is_unclear)
    state = torch.zeros_like(u + v).expand(len(labels), -1, -1)
    state = torch.where((near | inside).any(1), torch.full_like(state, -1.0), state)
    state = torch.where(core.any(1), torch.ones_like(state), state)
    # What lies before something large is the small one's.
    area = torch.where(core, w * h, torch.full_like(w * h, 1e9))
    owner = area.argmin(1)

    def of_owner(values):
        return values.gather(1, owner.flatten(1)).view_as(owner)

    box = torch.stack([of_owner(labels[:, :, i]) for i in (U, V, W, H)], -1)
    color = of_owner(labels[:, :, CLASS]).long()
    # Many cells of a large object count for few.
    weight = of_owner(core.float().sum((2, 3)).clamp(min=1.0) ** -0.5)
    return state, box, color, torch.where(state > 0.5, weight, torch.ones_like(weight))


def boxes_of(cells):
    """u, v, w, h in pixels of every cell: count x rows x columns x 4."""
    rows, columns = cells.shape[2:]
    v = (torch.arange(rows, device=cells.device) + 0.5)[None, :, None]
    u = (torch.arange(columns, device=cells.device) + 0.5)[None, None, :]
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


def loss_of(cells, labels):
    """Of score, box and colour. No cell is picked out: that would make a graphics processor wait."""
    state, box, color, weight = targets(labels, *cells.shape[2:])
    found = state > 0.5
    counts = torch.where(found, weight, torch.zeros_like(weight))
    total = counts.sum().clamp(min=1.0)
    made = boxes_of(cells)
    asked = torch.where(found[..., None], box, made.detach())
    iou, giou = overlap(made, asked)
    # GIoU alone starts slowly where boxes are a cell or two wide.
    offset = (made[..., :2] - asked[..., :2]) / asked[..., 2:].clamp(min=STRIDE)
    size = torch.log(made[..., 2:] / asked[..., 2:].clamp(min=1e-3))
    misfit = torch.cat([offset, size], -1)
    misfit = functional.smooth_l1_loss(misfit, torch.zeros_like(misfit), beta=0.05,
                                       reduction="none").sum(-1)
    # The score is to say how surely the box fits [after Li 2020, quality focal loss].
    fits = ((iou.detach() - 0.3) / 0.5).clamp(0.0, 1.0)
    wanted = torch.where(found, fits, torch.zeros_like(fits))
    focus = (wanted - torch.sigmoid(cells[:, 0])).detach().abs().pow(1.5) * (state > -0.5) * weight
    objectness = (focus * functional.binary_cross_entropy_with_logits(
        cells[:, 0], wanted, reduction="none")).sum() / total
    fit = (counts * (1.0 - giou + misfit)).sum() / total
    classes = (counts * functional.cross_entropy(cells[:, 5:], color,
                                                 reduction="none")).sum() / total
    return objectness, fit, classes
