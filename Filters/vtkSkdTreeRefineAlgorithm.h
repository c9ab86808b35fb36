// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSkdTreeRefineAlgorithm
 * @brief   base class of filters that refine cells by criteria
 *
 * Refinement criteria, each with a level of its own: cells that parts of a geometry intersect or
 * come near, cells inside the geometry, and a field (port 2, optional).
 */

#ifndef vtkSkdTreeRefineAlgorithm_h
#define vtkSkdTreeRefineAlgorithm_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkFiltersSkdTreeModule.h" // For export macro
#include "vtkSkdTreeSetWithin.h"     // For properties that have a range
#include "vtkSkdTreeVersion.h"       // For the differences between VTK's versions

#include <memory> // For std::unique_ptr

namespace skdtree
{
class SkdFilterInputs;
class SkdRefineState;
struct SkdSearchRange;
}

VTK_ABI_NAMESPACE_BEGIN

class VTKFILTERSSKDTREE_EXPORT vtkSkdTreeRefineAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkSkdTreeRefineAlgorithm, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OverlapTests
  {
    EXACT = 0,
    BLIND = 1
  };
  enum FieldTests
  {
    DIFFERENCE = 0,
    GRADIENT = 1,
    VALUE = 2,
    SECOND_DIFFERENCE = 3
  };
  enum Balances
  {
    NONE = 0,
    FACE = 1,
    EDGE = 2,
    CORNER = 3
  };

  //@{
  /**
   * The solution (port 2, optional): any data set, or composite data, whose arrays are refinement
   * criteria. See AddFieldArray.
   */
  void SetFieldConnection(vtkAlgorithmOutput* algOutput);
  void SetFieldData(vtkDataObject* field);
  //@}

  //@{
  /**
   * The maximum refinement level: each level halves the size of a cell (or divides it by the branch
   * factor). Range 0 to 30.
   */
  vtkSkdTreeChoiceMacro(MaximumLevel, 0, 30);
  //@}

  //@{
  /**
   * The test for the intersection of a part and a cell: EXACT (default), or BLIND, by the safety
   * boxes of the part's cells, which refines more: hardly more if these are small compared to the
   * leaves, several times as many cells if they are large and oblique.
   */
  vtkSkdTreeChoiceMacro(OverlapTest, EXACT, BLIND);
  //@}

  //@{
  /**
   * 2:1 balance: the adjacency across which leaves differ by at most one level: NONE (default),
   * FACE, EDGE (faces and edges) or CORNER (all).
   */
  vtkSkdTreeChoiceMacro(Balance, NONE, CORNER);
  //@}

  //@{
  /**
   * A maximum level for a part of composite data, given by its flat block index; other parts have
   * the MaximumLevel, which is an upper limit for all.
   */
  void AddPartLevel(int blockIndex, int level);
  void RemoveAllPartLevels();
  //@}

  //@{
  /**
   * Refine all cells within a distance of a part to a level, at most MaximumLevel. The distance
   * between a cell and the parts' cells is exact; curved cells are approximated by 8 straight
   * pieces along each parameter. The level is an integer; both arguments are doubles because
   * ParaView's lists have one type.
   */
  void AddDistanceBand(double distance, double level);
  void RemoveAllDistanceBands();
  //@}

  //@{
  /**
   * Refine cells whose centre is inside the closed surface that the parts are, or that bounds them,
   * to this level, at most MaximumLevel. This is exact, including overlapping bodies; for a surface
   * with open edges, which a warning counts, as with the method AUTOMATIC of
   * vtkSkdTreePointInOut. Default 0: not a criterion.
   */
  vtkSkdTreeChoiceMacro(InsideLevel, 0, 30);
  //@}

  //@{
  /**
   * The number of layers of cells of the same level around refined cells that are refined too.
   * Default 0.
   */
  vtkSkdTreeChoiceMacro(GrowingLayers, 0, 100);
  //@}

  //@{
  /**
   * Stop at MinimumSurfaceLevel where the surface is nearly flat: beyond it, refine only cells in
   * which the normal of a part's cell deviates by more than NormalDeviation (degrees, 0 to 180)
   * from the mean of that part's normals in the cell. So edges, strong curvature and narrow gaps
   * within a part get the maximum level and flat regions do not. Normals follow the order of the
   * cells' points; parts with cells other than flat surface cells are always refined. Default off,
   * 15 degrees, level 3.
   */
  vtkSkdTreeSwitchMacro(RefineByNormalDeviation);
  vtkSkdTreeWithinMacro(NormalDeviation, double, 0.0, 180.0);
  vtkSkdTreeChoiceMacro(MinimumSurfaceLevel, 0, 30);
  //@}

  //@{
  /**
   * Arrays of the field, point or cell data, that are refinement criteria; of several components
   * the magnitude. The values in a cell are those at the field's points in it, those interpolated
   * at its corners and its centre, and of cell data those of the field's cells that intersect it;
   * values that are not finite are ignored. A warning lists names that the field does not have.
   */
  void AddFieldArray(const char* name);
  void RemoveAllFieldArrays();
  //@}

  //@{
  /**
   * The condition for refinement: DIFFERENCE (default): two values in the cell differ by more than
   * FieldThreshold; GRADIENT: a cell of the field that intersects it has two points whose values
   * differ by more than FieldThreshold times their distance (point data only); VALUE: one value is
   * in FieldRange; SECOND_DIFFERENCE: Loehner's normalised second difference of interpolated
   * values, at the centre of the cell's box and half a side from it along one or two axes, is more
   * than FieldThreshold. That is 0 where the field is linear and at most 1 whatever the field's
   * unit: 0.8 finds shocks and fronts, less finds more. Points outside of the field do not count.
   */
  vtkSkdTreeChoiceMacro(FieldTest, DIFFERENCE, SECOND_DIFFERENCE);
  //@}

  //@{
  /**
   * See FieldTest. Default 0: any difference.
   */
  vtkSkdTreeWithinMacro(FieldThreshold, double, 0.0, VTK_DOUBLE_MAX);
  //@}

  //@{
  /**
   * See FieldTest; inclusive. Default (0, 1).
   */
  vtkSkdTreeFinite2Macro(FieldRange);
  //@}

  //@{
  /**
   * Whether FieldThreshold and FieldRange are shares of the range of each array's finite values
   * (over all blocks), so that one value fits several arrays: a difference of 0.1 is a tenth of the
   * range, a gradient of 1 the range over the diagonal of the field's bounds, a range of (0.5, 1)
   * the upper half. Of no effect on SECOND_DIFFERENCE. Default off.
   */
  vtkSkdTreeSwitchMacro(RelativeFieldThreshold);
  //@}

  //@{
  /**
   * The level to which the field refines cells, at most MaximumLevel. Default 30.
   */
  vtkSkdTreeChoiceMacro(FieldLevel, 0, 30);
  //@}

  //@{
  /**
   * The maximum number of cells. If the next level would exceed it, refinement stops with a warning
   * that gives the level. Default 20 million.
   */
  vtkSetClampMacro(CellLimit, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(CellLimit, vtkIdType);
  //@}

  //@{
  /**
   * The largest distance of facets from a curved face of the parts in inside tests, relative to the
   * diagonal of the bounds: see vtkSkdTreeFacetAlgorithm::SetChordalDeviation. Default 1e-4.
   */
  vtkSkdTreeWithinMacro(ChordalDeviation, double, 1e-7, 1.0);
  //@}

  //@{
  /**
   * See vtkSkdTreeCellLocator::SetEpsilon. Default 1e-9.
   */
  vtkSkdTreeWithinMacro(Epsilon, double, 0.0, 1.0);
  //@}

  /**
   * Passes the inputs on without broken cells: see "Bad input" in vtkSkdTreeCellLocator.
   */
  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  /// So many input ports, and one output. The inputs from a port on are needed whole, whatever
  /// piece is requested: any of it may matter to it. Times and pieces are handled as by
  /// vtkSkdTreeSourceAlgorithm.
  vtkSkdTreeRefineAlgorithm(int inputPorts, int firstWholePort);
  ~vtkSkdTreeRefineAlgorithm() override;

  /// All ports take meshes; all but the first are optional.
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  int MaximumLevel = 5;
  int OverlapTest = EXACT;
  int Balance = NONE;
  int InsideLevel = 0;
  int GrowingLayers = 0;
  bool RefineByNormalDeviation = false;
  double NormalDeviation = 15.0;
  int MinimumSurfaceLevel = 3;
  int FieldTest = DIFFERENCE;
  double FieldThreshold = 0.0;
  double FieldRange[2] = { 0.0, 1.0 };
  bool RelativeFieldThreshold = false;
  int FieldLevel = 30;
  vtkIdType CellLimit = 20000000;
  double ChordalDeviation = 1e-4;
  double Epsilon = 1e-9;

  /// Called before inputs are gathered: says how, if not all of what is needed whole on each
  /// process.
  virtual void SetUpInputs(skdtree::SkdFilterInputs& inputs);

  /// Of a field that is exchanged, what is needed for settings relative to its range of values.
  void ReachField(skdtree::SkdSearchRange& range) const;

  /// Copies the settings into the State before it is updated.
  void PassOptions();

  std::unique_ptr<skdtree::SkdRefineState>
    State; // trees of parts and field, kept while they are the same

private:
  vtkSkdTreeRefineAlgorithm(const vtkSkdTreeRefineAlgorithm&) = delete;
  void operator=(const vtkSkdTreeRefineAlgorithm&) = delete;

  std::unique_ptr<skdtree::SkdFilterInputs> Inputs;
};

VTK_ABI_NAMESPACE_END
#endif
