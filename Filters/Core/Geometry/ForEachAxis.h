// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef skd_Geometry_ForEachAxis_h
#define skd_Geometry_ForEachAxis_h

#include <utility>

namespace skd
{

/// body(0) .. body(D - 1), unrolled: compilers keep short loops over axes as loops, with values in
/// memory instead of registers. A box that is written to memory number by number and copied from
/// there at once costs more than all arithmetic on it.
template <class Body, int... Axes>
void ForEachAxis(std::integer_sequence<int, Axes...>, [[maybe_unused]] Body body)
{
  (body(Axes), ...);
}
template <int D, class Body>
void ForEachAxis(Body body)
{
  ForEachAxis(std::make_integer_sequence<int, D>(), body);
}

}

#endif
