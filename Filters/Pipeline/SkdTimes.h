// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SkdTimes.h
 * @brief The times at which a filter of several inputs has answers.
 *
 * VTK's pipeline tells the outputs the times of the first input alone, and executes a filter for
 * another time only if its outputs have times. A filter whose second input changes in time must
 * therefore say so itself.
 */

#ifndef SkdTimes_h
#define SkdTimes_h

class vtkInformationVector;

namespace skdtree
{
/// Gives all outputs the union of all inputs' time steps, and a range that includes all of theirs.
/// For REQUEST_INFORMATION. O(n log n) for n steps.
void SkdUniteTimes(vtkInformationVector** inputs, int ports, vtkInformationVector* outputs);

/// Marks the data of all outputs with the time that was requested. Data of an input may have an
/// earlier one, the last at which that input changed; an output with that mark would pass for one
/// of that time, although another input has changed since. For the end of REQUEST_DATA.
void SkdMarkRequestedTime(vtkInformationVector* outputs);
}

#endif
