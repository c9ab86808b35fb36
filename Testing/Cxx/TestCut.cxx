// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
// The few boxes of each process that all know: no process is missed that has something in a box.

#include "Support/MeshPieces.h"
#include "Support/ThreadTransport.h"

#include "Exchange/SkdCut.h"

#include <gtest/gtest.h>

#include <cmath>
#include <mutex>

using namespace skdtest;
using namespace skdtree;

namespace
{
skd::Box3 RandomBox(Random& random, double size)
{
  skd::Box3 box;
  skd::Vector3 corner;
  for (int axis = 0; axis < 3; ++axis)
  {
    corner[axis] = random.Between(-10.0, 10.0);
  }
  box.Add(corner);
  box.Add(corner + skd::Vector3{ { size, size, size } });
  return box;
}

/// Of each process; the last has nothing.
std::vector<std::vector<skd::Box3>> BoxesOf(int processes, std::size_t number)
{
  Random random(processes);
  std::vector<std::vector<skd::Box3>> boxes(static_cast<std::size_t>(processes));
  for (std::size_t process = 0; process + 1 < boxes.size(); ++process)
  {
    for (std::size_t i = 0; i < number; ++i)
    {
      boxes[process].push_back(RandomBox(random, 0.1));
    }
  }
  return boxes;
}

void ExpectFound(const SkdCut& cut, const std::vector<std::vector<skd::Box3>>& boxes)
{
  Random random(17);
  std::vector<int> found;
  for (int query = 0; query < 200; ++query)
  {
    const skd::Box3 wanted = RandomBox(random, 0.5);
    cut.FindOverlapping(wanted, found);
    for (std::size_t process = 0; process < boxes.size(); ++process)
    {
      const bool isThere = std::any_of(boxes[process].begin(), boxes[process].end(),
        [&](const skd::Box3& box) { return box.Overlaps(wanted); });
      const auto count = std::count(found.begin(), found.end(), static_cast<int>(process));
      EXPECT_LE(count, 1);
      EXPECT_TRUE(!isThere || count == 1) << query << " " << process;
    }
  }
}

TEST(Cut, MissesNoProcess)
{
  for (const std::size_t number : { 0, 1, 30, 500 })
  {
    const auto boxes = BoxesOf(5, number);
    std::mutex mutex; // GoogleTest's expectations are not for several threads at once
    ThreadTransport::RunAll(5,
      [&](SkdTransport& transport)
      {
        const SkdCut cut(transport, boxes[static_cast<std::size_t>(transport.GetRank())]);
        const std::lock_guard<std::mutex> lock(mutex);
        EXPECT_EQ(cut.GetNumberOfProcesses(), 5);
        EXPECT_LE(cut.GetBoxes().size(), 4u * 64u);
        EXPECT_TRUE(cut.GetBounds(4).IsEmpty());
        ExpectFound(cut, boxes);
      });
  }
}

// What all know of all does not grow with the number of processes.
TEST(Cut, HasAsManyBoxesOfFewProcessesAsOfMany)
{
  for (const int processes : { 8, 11, 16, 32 })
  {
    const auto boxes = BoxesOf(processes, 300);
    std::mutex mutex;
    ThreadTransport::RunAll(processes,
      [&](SkdTransport& transport)
      {
        const SkdCut cut(transport, boxes[static_cast<std::size_t>(transport.GetRank())]);
        const std::lock_guard<std::mutex> lock(mutex);
        EXPECT_LE(cut.GetBoxes().size(), 512u) << processes;
        EXPECT_GE(cut.GetBoxes().size(), 256u) << processes;
        ExpectFound(cut, boxes);
      });
  }
}

TEST(Transport, GathersTheMessagesOfAllInAFewSteps)
{
  for (const int processes : { 1, 2, 3, 4, 7, 8, 13 })
  {
    std::mutex mutex;
    ThreadTransport::RunAll(processes,
      [&](SkdTransport& transport)
      {
        const auto messageOf = [](int rank)
        { return SkdBytes(static_cast<std::size_t>(rank % 3), static_cast<char>('a' + rank)); };
        const std::vector<SkdBytes> all = transport.GatherAll(messageOf(transport.GetRank()));
        const std::lock_guard<std::mutex> lock(mutex);
        ASSERT_EQ(all.size(), static_cast<std::size_t>(processes));
        for (int rank = 0; rank < processes; ++rank)
        {
          EXPECT_EQ(all[static_cast<std::size_t>(rank)], messageOf(rank)) << rank;
        }
        EXPECT_EQ(transport.GetTraffic().Messages,
          static_cast<std::uint64_t>(std::ceil(std::log2(processes))));
      });
  }
}

// Empty ones, small ones that others pass on, and large ones.
TEST(Transport, EachGetsWhatEachSendsIt)
{
  for (const int processes : { 1, 2, 3, 4, 7, 8, 13 })
  {
    for (const std::size_t unit : { 1, 3000 })
    {
      std::mutex mutex;
      ThreadTransport::RunAll(processes,
        [&](SkdTransport& transport)
        {
          const auto messageOf = [unit](int from, int to)
          {
            const auto size = static_cast<std::size_t>((3 * from + 5 * to) % 7) * unit;
            return SkdBytes(size, static_cast<char>(16 * from + to));
          };
          const int rank = transport.GetRank();
          std::vector<int> times(static_cast<std::size_t>(processes), 0);
          transport.Exchange([&](int to) { return messageOf(rank, to); },
            [&](int from, const SkdBytes& message)
            {
              const std::lock_guard<std::mutex> lock(mutex);
              ++times[static_cast<std::size_t>(from)];
              EXPECT_EQ(message, messageOf(from, rank)) << from << " to " << rank;
            });
          const std::lock_guard<std::mutex> lock(mutex);
          EXPECT_EQ(times, std::vector<int>(times.size(), 1));
          if (unit == 1)
          {
            EXPECT_LE(transport.GetTraffic().Messages,
              static_cast<std::uint64_t>(std::ceil(std::log2(processes))));
          }
        });
    }
  }
}

// A box of a curved cell contains more than its points; a ghost's or a broken cell's is empty.
TEST(Cut, BoxesAreOfCellsThatCount)
{
  const auto grid = MakeGrid(Hexahedra(2));
  grid->AllocateCellGhostArray()->SetValue(3, vtkDataSetAttributes::DUPLICATECELL);
  grid->GetPoints()->SetPoint(0, std::nan(""), 0.0, 0.0);
  const std::vector<skd::Box3> boxes = SkdBoxesOfCells(grid, true);
  ASSERT_EQ(boxes.size(), 8u);
  for (std::size_t cell = 0; cell < boxes.size(); ++cell)
  {
    EXPECT_EQ(boxes[cell].IsEmpty(), cell == 0 || cell == 3) << cell;
  }
  EXPECT_FALSE(SkdBoxesOfCells(grid, false)[3].IsEmpty());
  EXPECT_TRUE(SkdBoxesOfPoints(grid)[0].IsEmpty());
  EXPECT_FALSE(SkdBoxesOfPoints(grid)[1].IsEmpty());
}

}
