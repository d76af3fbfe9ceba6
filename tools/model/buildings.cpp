#include "tools/model/buildings.hpp"

#include "tools/model/box_solid.hpp"

namespace spoctree::model {

PolygonMesh make_house_plan() {
  BoxSolid house;
  house.fill({0, 0, 0}, {10000, 8000, 2900});
  house.hollow({200, 200, 200}, {6000, 7800, 2700});    // the living room
  house.hollow({6200, 4100, 200}, {9800, 7800, 2700});  // the kitchen
  house.hollow({6200, 200, 200}, {9800, 3900, 2700});   // the dining room
  house.hollow({6000, 6000, 200}, {6200, 7000, 2200});  // doors
  house.hollow({6000, 1400, 200}, {6200, 2600, 2200});
  house.hollow({7400, 3900, 1200}, {8800, 4100, 2000});  // the hatch
  return house.mesh();
}

PolygonMesh make_city_block() {
  BoxSolid block;
  block.fill({0, 0, -500}, {60000, 60000, 0});
  block.fill({6000, 20000, 0}, {18000, 44000, 15000});
  block.fill({6000, 6000, 0}, {18000, 16000, 30000});
  block.fill({22000, 6000, 0}, {42000, 18000, 12000});
  block.fill({46000, 6000, 0}, {54000, 22000, 21000});
  block.fill({42000, 26000, 0}, {54000, 44000, 18000});
  block.hollow({42000, 34000, 0}, {54000, 38000, 5000});  // the archway
  block.fill({46000, 50000, 0}, {54000, 56000, 9000});
  block.fill({20000, 46000, 0}, {42000, 54000, 24000});
  block.fill({24000, 46000, 24000}, {34000, 54000, 33000});
  block.fill({6000, 48000, 0}, {16000, 56000, 18000});
  block.fill({28000, 28000, 0}, {32000, 32000, 2000});  // the pillar
  block.fill({29000, 29000, 2000}, {31000, 31000, 10000});
  return block.mesh();
}

}  // namespace spoctree::model
