# SPDX-License-Identifier: MIT
"""The detector network: what it computes, and its export.

Input: 3 x 240 x 320, blue, green, red, level / 128 - 1; any height and width that 16 divides do.
Output: 13 x 30 x 40, per cell of 8 pixels: logit of an object, offset of its box's middle from the
cell's in cells (u, v), logarithm of its size over 32 pixels (w, h), one logit per colour.
"""
import inspect
import os

import torch
from torch import nn

COLORS = ["yellow", "orange", "red", "green", "white", "blue", "black", "purple"]
STRIDE = 8
SIZE_UNIT = 32.0


class Block(nn.Module):
    """3 x 3 convolution, norm, ReLU; a shortcut where the shape stays."""

    def __init__(self, inputs, outputs, stride=1, dilation=1):
        super().__init__()
        self.conv = nn.Conv2d(inputs, outputs, 3, stride, dilation, dilation, bias=False)
        self.norm = nn.BatchNorm2d(outputs)
        self.is_residual = inputs == outputs and stride == 1

    def forward(self, x):
        y = self.norm(self.conv(x))
        return torch.relu(x + y if self.is_residual else y)

    def fold(self):
        """Puts the norm into the convolution: OpenCV 4.6 refuses what torch makes of both."""
        scale = self.norm.weight / torch.sqrt(self.norm.running_var + self.norm.eps)
        folded = nn.Conv2d(self.conv.in_channels, self.conv.out_channels, 3, self.conv.stride,
                           self.conv.padding, self.conv.dilation)
        folded.weight.data = (self.conv.weight * scale[:, None, None, None]).detach()
        folded.bias.data = (self.norm.bias - self.norm.running_mean * scale).detach()
        self.conv, self.norm = folded, nn.Identity()


class Network(nn.Module):
    """Plain convolutions to a sixteenth of the size, merged back with what an eighth still shows."""

    def __init__(self, widths=(16, 32, 64, 96)):
        super().__init__()
        a, b, c, d = widths
        self.fine = nn.Sequential(Block(3, a, 2), Block(a, b, 2), Block(b, b), Block(b, c, 2),
                                  Block(c, c))
        self.coarse = nn.Sequential(Block(c, d, 2), Block(d, d), Block(d, d, dilation=2),
                                    Block(d, d, dilation=2))
        self.reduce = nn.Conv2d(d, c, 1)
        self.merge = nn.Sequential(Block(c, c), Block(c, c))
        self.head = nn.Conv2d(c, 5 + len(COLORS), 1)
        nn.init.constant_(self.head.bias[:1], -4.0)  # objects are rare

    def forward(self, x):
        fine = self.fine(x)
        coarse = self.reduce(self.coarse(fine))
        raised = nn.functional.interpolate(coarse, scale_factor=2.0, mode="nearest")
        return self.head(self.merge(torch.relu(fine + raised)))


def export(network, path):
    """Writes ONNX with the norms folded, and beside it the description that a mission names, its
    confidences not yet calibrated. The network is changed."""
    network.eval()
    for module in network.modules():
        if isinstance(module, Block):
            module.fold()
    # Equal weights would be shared through a node that OpenCV 4.6 does not know; trained ones differ.
    # Newer torch has a second exporter, which knows no opset as old as OpenCV 4.6 reads.
    options = inspect.signature(torch.onnx.export).parameters
    torch.onnx.export(network, torch.zeros(1, 3, 240, 320), path, opset_version=11,
                      input_names=["image"], output_names=["cells"],
                      **({"dynamo": False} if "dynamo" in options else {}))
    description = os.path.splitext(path)[0] + ".yaml"
    with open(description, "w", encoding="ascii") as out:
        out.write(f"""# A detector network: docs/detectors.md. Made by training/detector.
weights: {os.path.basename(path)}
colors: [{", ".join(COLORS)}]
stride_px: {STRIDE}
size_unit_px: {SIZE_UNIT:g}
input_pixels: {240 * 320}
# Probability that a box is right: logistic in these, times 1, logit of score and of colour, roundness.
confidence_offset: 0
confidence_per_score: 1
confidence_per_color: 0
confidence_per_roundness: 0
# The same where color_shape was asked, too (detector = combined): also whether it has a box there, and its confidence's logit.
witnesses_offset: 0
witnesses_per_score: 1
witnesses_per_color: 0
witnesses_per_roundness: 0
witnesses_shape_found: 0
witnesses_per_shape: 0
""")
