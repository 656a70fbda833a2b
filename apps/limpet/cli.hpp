// SPDX-License-Identifier: MIT
// What every verb declares its words with, and the codes it ends with.
#pragma once

#include "limpet/console/command.hpp"
#include "limpet/console/exit_code.hpp"
