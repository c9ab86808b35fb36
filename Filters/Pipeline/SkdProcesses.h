// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdProcesses_h
#define SkdProcesses_h

#include "Core/Mesh/Processes.h"

#include <memory>

class vtkInformation;

/// The processes of the global controller, if there are several and each one requests its own
/// piece; else nullptr.
std::unique_ptr<skd::Processes> SkdProcessesOf(vtkInformation* output);

#endif
