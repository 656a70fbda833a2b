# SPDX-License-Identifier: MIT
"""Pictures of training_frames, and the batches that are drawn of them: cut out, mirrored, and taken
again by worse cameras in worse water. All of a batch at once, on the processor that trains."""
import csv
import math
import os

import numpy
import torch
from torch.nn import functional

from network import COLORS

HEIGHT, WIDTH = 240, 320
CUT_HEIGHT, CUT_WIDTH = 128, 160
CUTS_PER_PICTURE = 3  # about as many pixels in a batch of cuts as in one of whole pictures
MOST_LABELS = 8  # of a picture
# What is not asked for, as in labelled_picture.cpp; batches make other things small and faint.
LEAST_SIDE = 6.0  # pixels
LEAST_CONTRAST = 10.0  # levels
LEAST_SHOWN = 0.4  # of what the picture showed

# Columns of labels: class, middle, size, whether it is unclear, whether there is one.
CLASS, U, V, W, H, UNCLEAR, VALID = range(7)


def read_labels(folder, count):
    """count x MOST_LABELS x 7; rows of zeros where there are fewer."""
    labels = numpy.zeros((count, MOST_LABELS, 7), numpy.float32)
    taken = numpy.zeros(count, int)
    with open(os.path.join(folder, "labels.csv"), encoding="ascii") as table:
        for row in csv.DictReader(table):
            frame = int(row["frame"])
            labels[frame, taken[frame]] = [COLORS.index(row["class"])] + [
                float(row[key]) for key in ("u", "v", "w", "h", "unclear")] + [1.0]
            taken[frame] += 1
    return labels


class Pictures:
    """Pictures of some folders and their labels, in the memory of `device`."""

    def __init__(self, folders, device="cpu"):
        self.device = device
        self.waiting = list(folders)
        self.pixels = torch.empty((0, HEIGHT, WIDTH, 3), dtype=torch.uint8, device=device)
        self.labels = torch.empty((0, MOST_LABELS, 7), device=device)
        self.take_up()

    def take_up(self):
        """Reads those of the folders that are there by now: drawing pictures takes longer than
        training needs to begin. A folder gets its name when it is complete."""
        ready = [folder for folder in self.waiting if os.path.isdir(folder)]
        if not ready:
            return
        self.waiting = [folder for folder in self.waiting if folder not in ready]
        pixels, labels = [self.pixels], [self.labels]
        for folder in ready:
            data = numpy.fromfile(os.path.join(folder, "pixels.bin"), numpy.uint8)
            data = data.reshape(-1, HEIGHT, WIDTH, 3)
            pixels.append(torch.from_numpy(data).to(self.device))
            labels.append(torch.from_numpy(read_labels(folder, len(data))).to(self.device))
        self.pixels, self.labels = torch.cat(pixels), torch.cat(labels)
        del pixels
        torch.cuda.empty_cache()  # torch would keep what held the fewer pictures

    def __len__(self):
        return len(self.pixels)


class Draws:
    """Random numbers, one per picture of a batch."""

    def __init__(self, seed, device):
        self.generator = torch.Generator(device)
        self.generator.manual_seed(seed)
        self.device = device

    def uniform(self, low, high, *shape):
        values = torch.rand(shape, generator=self.generator, device=self.device)
        return low + (high - low) * values

    def log_uniform(self, low, high, *shape):
        return torch.exp(self.uniform(math.log(low), math.log(high), *shape))

    def normal(self, sigma, *shape):
        return sigma * torch.randn(shape, generator=self.generator, device=self.device)

    def chance(self, share, *shape):
        return self.uniform(0.0, 1.0, *shape) < share

    def sometimes(self, share, values, otherwise):
        """`values` for a share of the pictures (their first dimension), else `otherwise`."""
        shape = [len(values)] + [1] * (values.dim() - 1)
        return torch.where(self.chance(share, *shape), values, torch.full_like(values, otherwise))


def draw_window(labels, whole, draws):
    """Left, top, width and height of what is cut out of each picture."""
    count = len(labels)
    if whole:
        scale = draws.sometimes(0.5, draws.uniform(0.7, 1.0, count), 1.0)
    else:
        scale = draws.log_uniform(0.75, 1.6, count)
    height, width = (HEIGHT, WIDTH) if whole else (CUT_HEIGHT, CUT_WIDTH)
    size = torch.stack([width * scale, height * scale], 1)
    room = torch.tensor([WIDTH, HEIGHT], device=draws.device) - size
    corner = draws.uniform(0.0, 1.0, count, 2) * room
    # Most of a picture is empty: most cuts show something.
    objects = labels[:, :, VALID].sum(1)
    chosen = (draws.uniform(0.0, 1.0, count) * objects).long().clamp(max=MOST_LABELS - 1)
    middle = labels[torch.arange(count, device=draws.device), chosen][:, [U, V]]
    around = middle - size * draws.uniform(0.1, 0.9, count, 2)
    shows = draws.chance(0.7, count) & (objects > 0)
    corner = torch.where(shows[:, None], around, corner)
    return torch.minimum(corner.clamp(min=0.0), room), size


def cut(images, labels, window, mirrored, shape):
    """Windows of the pictures, brought to `shape`, and their labels."""
    corner, size = window
    height, width = shape
    axes = []
    for axis, (cells, most) in enumerate(((width, WIDTH), (height, HEIGHT))):
        share = (torch.arange(cells, device=images.device) + 0.5) / cells
        share = torch.where(mirrored[:, axis, None], 1.0 - share, share)
        axes.append(2.0 * (corner[:, axis, None] + share * size[:, axis, None]) / most - 1.0)
    grid = torch.stack([axes[0][:, None, :].expand(-1, height, -1),
                        axes[1][:, :, None].expand(-1, -1, width)], -1)
    made = functional.grid_sample(images, grid, mode="bilinear", padding_mode="border",
                                  align_corners=False)
    return made, cut_labels(labels, window, mirrored, shape)


def cut_labels(labels, window, mirrored, shape):
    """Labels in the windows; what loses too much of itself or gets too small becomes unclear."""
    corner, size = window
    scale = torch.tensor([shape[1], shape[0]], device=labels.device) / size
    most = torch.tensor([shape[1], shape[0]], device=labels.device, dtype=torch.float32)
    half = labels[:, :, [W, H]] / 2
    low = (labels[:, :, [U, V]] - half - corner[:, None]) * scale[:, None]
    high = (labels[:, :, [U, V]] + half - corner[:, None]) * scale[:, None]
    kept_low, kept_high = low.clamp(min=0.0), torch.minimum(high, most)
    middle, extent = (kept_low + kept_high) / 2, (kept_high - kept_low).clamp(min=0.0)
    middle = torch.where(mirrored[:, None], most - middle, middle)
    shown = extent.prod(-1) / (high - low).prod(-1).clamp(min=1e-3)
    made = labels.clone()
    made[:, :, [U, V]] = middle
    made[:, :, [W, H]] = extent
    smallest = extent.min(-1).values
    made[:, :, VALID] *= (smallest >= 1.0).float()
    hardly = (shown < LEAST_SHOWN) | (smallest < LEAST_SIDE)
    made[:, :, UNCLEAR] = torch.maximum(labels[:, :, UNCLEAR], hardly.float())
    return made


def blurred(images, sigma):
    """By one Gaussian for all. Sums of shifted pictures: convolutions of one channel are slow."""
    reach = 3
    steps = torch.arange(-reach, reach + 1, device=images.device)
    kernel = torch.exp(-0.5 * (steps / sigma) ** 2)
    kernel = kernel / kernel.sum()
    for axis in (2, 3):
        margin = (reach, reach, 0, 0) if axis == 3 else (0, 0, reach, reach)
        padded = functional.pad(images, margin, mode="replicate")
        length = images.shape[axis]
        images = sum(kernel[i] * padded.narrow(axis, i, length) for i in range(2 * reach + 1))
    return images


def recolor(images, draws):
    """Haze, exposure up to burnt out, white balance, lost red."""
    count = len(images)
    one = (count, 1, 1, 1)
    mean = images.mean((2, 3), keepdim=True)
    haze = draws.sometimes(0.25, draws.uniform(0.0, 0.75, *one), 0.0)
    gain = torch.exp(draws.normal(0.12, count, 3, 1, 1)) * torch.exp(draws.normal(0.2, *one))
    gain = draws.sometimes(0.5, gain, 1.0)
    gain = gain * draws.sometimes(0.4, draws.log_uniform(0.4, 2.5, *one), 1.0)
    red = draws.sometimes(0.2, draws.uniform(0.2, 1.0, *one), 1.0)
    gain = gain * torch.cat([torch.ones_like(red), torch.ones_like(red), red], 1)
    offset = draws.sometimes(0.5, draws.normal(10.0, *one), 0.0)
    return (images * ((1.0 - haze) * gain) + (haze * gain * mean + offset)).clamp_(0.0, 255.0)


def blur_some(images, draws):
    """Where a picture stands in its batch is chance: a fifth is the first fifth."""
    some = images[:len(images) // 5]
    some.copy_(blurred(some, draws.uniform(0.4, 1.6, 1)))


def add_noise_to_some(images, draws):
    """White noise or grain; to some that are blurred, too, and to some that are not."""
    first, grainy, last = (int(share * len(images)) for share in (0.1, 0.26, 0.5))
    noise = draws.normal(1.0, last - first, *images.shape[1:])
    grain = noise[:grainy - first]
    grain.copy_(2.0 * blurred(grain, draws.uniform(0.4, 0.9, 1)))
    images[first:last] += noise * draws.log_uniform(1.0, 10.0, last - first, 1, 1, 1)


def worsen(images, draws):
    """As another camera in other water would have taken them; levels 0 to 255."""
    images = recolor(images, draws)
    blur_some(images, draws)
    add_noise_to_some(images, draws)
    return images.clamp_(0.0, 255.0).round_()


def contrasts(images, labels):
    """How far the mean colour of each label's ellipse is from that of a ring around it [levels]."""
    device = images.device
    angles = torch.arange(16, device=device) * (2.0 * math.pi / 16)
    height, width = images.shape[2:]

    def mean_at(radii):
        radii = torch.tensor(radii, device=device)[:, None]
        across = (radii * torch.cos(angles)).flatten()
        along = (radii * torch.sin(angles)).flatten()
        u = labels[:, :, U, None] + across * labels[:, :, W, None] / 2
        v = labels[:, :, V, None] + along * labels[:, :, H, None] / 2
        inside = ((u > 0) & (u < width) & (v > 0) & (v < height)).float()
        grid = torch.stack([2.0 * u / width - 1.0, 2.0 * v / height - 1.0], -1)
        seen = functional.grid_sample(images, grid, mode="nearest", align_corners=False)
        total = inside.sum(-1)
        return (seen * inside[:, None]).sum(-1) / total[:, None].clamp(min=1.0), total

    inner, _ = mean_at((0.2, 0.45, 0.6, 0.72, 0.84))
    outer, ring = mean_at((1.2, 1.35, 1.5))
    difference = torch.linalg.vector_norm(inner - outer, dim=1)
    return torch.where(ring > 0, difference, torch.zeros_like(difference))


def draw_batch(pictures, whole, count, draws):
    """`count` whole pictures, or some more cuts of pictures: network input and labels."""
    if not whole:
        count *= CUTS_PER_PICTURE
    index = (draws.uniform(0.0, 1.0, count) * len(pictures)).long().clamp(max=len(pictures) - 1)
    labels = pictures.labels[index]
    images = pictures.pixels[index].permute(0, 3, 1, 2).float()
    mirrored = torch.stack([draws.chance(0.5, count), draws.chance(0.25, count)], 1)
    shape = (HEIGHT, WIDTH) if whole else (CUT_HEIGHT, CUT_WIDTH)
    images, labels = cut(images, labels, draw_window(labels, whole, draws), mirrored, shape)
    images = worsen(images, draws)
    faint = (contrasts(images, labels) < LEAST_CONTRAST).float()
    labels[:, :, UNCLEAR] = torch.maximum(labels[:, :, UNCLEAR], faint)
    return images / 128.0 - 1.0, labels
