// SPDX-License-Identifier: MIT
// What every verb reads its words with, and the codes it ends with.
#pragma once

#include "limpet/console/arguments.hpp"
