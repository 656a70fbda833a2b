// SPDX-License-Identifier: MIT
// What the tests read beside precompiled.hpp.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "precompiled.hpp"
