#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Trains the detector network from scratch on pictures of training_frames.

    train.py --out FILE.onnx [--steps N | --seconds S] [--seed S] --held-out FOLDER... -- FOLDER...

Needs Debian's python3-torch and python3-numpy, or newer ones; a graphics processor is used if torch
sees one. README.md has the recipe that made the weights here.
"""
import argparse
import copy
import math
import time

import torch

from judging import judge
from network import Network, export
from objective import loss_of
from pictures import Draws, Pictures, draw_batch

WARM_UP = 0.1  # share of the training in which the learning rate rises
WHOLE_ONLY = 0.85  # from here on only whole pictures: so the network will see them
REPORT = 200  # steps


def read_arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--out", required=True)
    parser.add_argument("--steps", type=int, default=6000)
    parser.add_argument("--seconds", type=float, help="train so long, whatever steps that makes")
    parser.add_argument("--batch", type=int, default=8, help="whole pictures of a step")
    parser.add_argument("--rate", type=float, default=3e-3, help="greatest learning rate")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--widths", type=int, nargs=4, default=None)
    parser.add_argument("--held-out", nargs="+", default=[])
    parser.add_argument("folders", nargs="+", help="those that are not there yet are waited for")
    return parser.parse_args()


def share_of_rate(progress):
    """Up along a line, down along a cosine."""
    if progress < WARM_UP:
        return 0.04 + 0.96 * progress / WARM_UP
    return 0.5 + 0.5 * math.cos(math.pi * (progress - WARM_UP) / (1.0 - WARM_UP))


class Training:
    def __init__(self, given):
        self.given = given
        self.device = "cuda" if torch.cuda.is_available() else "cpu"
        torch.set_num_threads(given.threads)
        torch.backends.cudnn.benchmark = True
        torch.manual_seed(given.seed)
        self.pictures = Pictures(given.folders, self.device)
        while not len(self.pictures):
            time.sleep(1.0)
            self.pictures.take_up()
        self.draws = Draws(given.seed, self.device)
        network = Network(given.widths) if given.widths else Network()
        self.network = network.to(self.device, memory_format=torch.channels_last)
        # Of the weights over the last few hundred steps: steadier than any of them.
        self.average = copy.deepcopy(self.network)
        self.leaders, self.followers = (
            [values for values in one.state_dict().values() if values.dtype.is_floating_point]
            for one in (self.network, self.average))
        self.optimizer = torch.optim.AdamW(self.network.parameters(), given.rate, weight_decay=1e-3)
        self.start = time.time()

    def progress(self, step):
        if self.given.seconds:
            return min(1.0, (time.time() - self.start) / self.given.seconds)
        return step / self.given.steps

    def step(self, step, progress):
        """Losses of score, box and colour in one batch."""
        for group in self.optimizer.param_groups:
            group["lr"] = self.given.rate * share_of_rate(progress)
        whole = step % 3 == 0 or progress > WHOLE_ONLY
        images, labels = draw_batch(self.pictures, whole, self.given.batch, self.draws)
        images = images.contiguous(memory_format=torch.channels_last)
        with torch.autocast(self.device, dtype=torch.bfloat16, enabled=self.device == "cuda"):
            cells = self.network(images)
        losses = torch.stack(loss_of(cells.float(), labels))
        self.optimizer.zero_grad(set_to_none=True)
        losses.sum().backward()
        torch.nn.utils.clip_grad_norm_(self.network.parameters(), 5.0)
        self.optimizer.step()
        self.follow(step)
        return losses.detach()

    def follow(self, step):
        keep = min(0.998, step / (step + 50.0))
        torch._foreach_mul_(self.followers, keep)
        torch._foreach_add_(self.followers, self.leaders, alpha=1.0 - keep)

    def run(self):
        sums, step, progress = torch.zeros(3, device=self.device), 0, 0.0
        while progress < 1.0:
            step += 1
            progress = self.progress(step)
            sums += self.step(step, progress)
            if step % REPORT == 0:
                score, box, color = (sums / REPORT).tolist()
                sums.zero_()
                print(f"{step}, {100 * progress:.0f} %, {time.time() - self.start:.0f} s, "
                      f"{len(self.pictures)} pictures: object {score:.3f} box {box:.3f} "
                      f"class {color:.3f}", flush=True)
                self.pictures.take_up()
            if step % (10 * REPORT) == 0:
                torch.save(self.average.state_dict(), self.given.out + ".pt")
        return self.average.float().cpu().to(memory_format=torch.contiguous_format)


def main():
    given = read_arguments()
    network = Training(given).run()
    torch.save(network.state_dict(), given.out + ".pt")
    for folder in given.held_out:
        print(f"  {folder}")
        judge(network, Pictures([folder]))
    export(network, given.out)


if __name__ == "__main__":
    main()
