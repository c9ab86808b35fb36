// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file System.h
 * @brief what the numbers were measured with, in words
 */
#ifndef skdbench_System_h
#define skdbench_System_h

#include <string>

namespace skdbench
{

std::string DescribeVtk();     // version, whether it is optimised, threads' backend
std::string DescribeBuild();   // compiler of this program
std::string DescribeMachine(); // processor

}

#endif
