// SPDX-License-Identifier: MIT
// CMake keeps a precompiled header with a target, and a target needs a source.
