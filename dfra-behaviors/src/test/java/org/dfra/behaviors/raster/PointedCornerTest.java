package org.dfra.behaviors.raster;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.junit.jupiter.api.Test;

/** Regions whose corners are hardly an area, and were left unseen once. */
class PointedCornerTest {

  private static final LocalFrame FRAME = new LocalFrame(new GeoPosition(48, 11, 0));
  private static final double PROMISED = 1e-6; // metres

  @Test
  void seesTheTipOfASpike() {
    requireCornersSeen(
        0.5963370501554328,
        0.5963370501554328,
        4.043867257775545,
        new double[][] {
          {-8.558699934002009, 7.899817082938723}, {-9.622617236129917, 8.456420827124848},
          {-11.772019381329235, 15.757977532866104}, {-12.106172492933922, 5.899724332427371},
          {-9.834397721755158, 7.0022102521099665}, {-2.893917647867414, -17.267297345530082},
          {2.8414252828720827, -12.991424173943912}, {9.7895816770003, -8.610768732177178},
          {4.41854170828685, -9.854933926148624}, {6.2392612945519375, -6.519926643708041},
          {0.9624755580667701, 5.926624674178356}, {12.534399573869877, 13.631375132287692},
          {21.75263219132204, 0.22798177249730434}, {26.350926602156925, -8.129853953895436},
          {12.217641260514492, 17.810136553661238}, {3.6338628053875937, 9.797741924849232}
        });
  }

  @Test
  void seesCornersThatAreAMicrometreTooFar() {
    requireCornersSeen(
        3.6013393818714308,
        2.3086877705776256,
        0,
        new double[][] {
          {-8.002289305509546, 9.954183986073298}, {-3.811030286444619, 9.954132559597113},
          {-3.8109443986934295, 16.95413255997525}, {1.189055600852945, 16.95407121142416},
          {4.587770345956923, 16.954029510709997}, {4.58751268304325, -4.0459704881523875},
          {8.58751268272169, -4.046019566347227}, {8.587561761388491, -0.04601956771198188},
          {9.488546861239838, -0.04603062283521418}, {9.57364723351319, -0.04603166673485913},
          {9.573794469394391, 11.953968332521923}, {10.57379446945183, 11.953956063467029},
          {10.573438649132667, -17.0460439336925}, {9.573438649184226, -17.046031664661264},
          {9.573512267250386, -11.046031664188687}, {9.488411894992684, -11.04603062163958},
          {9.488399625341007, -12.04603062034152}, {8.587414525530766, -12.046019566086768},
          {8.587451334444587, -9.04601956548654}, {4.58745133478246, -9.045970487837762},
          {1.1887365897202504, -9.045928787376452}, {1.1886507020167096, -16.045928785692094},
          {-3.811349297596891, -16.045867437275785}, {-3.811312488730174, -13.045867437319837},
          {-8.0025715077886, -13.045816013316735}
        });
  }

  private static void requireCornersSeen(
      double swath, double spacing, double bearing, double[][] corners) {
    List<GeoPosition> outline = new ArrayList<>();
    for (double[] each : corners) {
      outline.add(FRAME.toGeo(new LocalPosition(each[0], each[1], 0)));
    }
    Region region = Region.of(outline);
    RasterPlan plan = RasterPlan.of(region, swath, spacing, bearing);
    for (GeoPosition each : region.corners()) {
      LocalPosition corner = region.frame().toLocal(each);
      double[] point = {corner.east(), corner.north()};
      assertThat(plan.lanes())
          .as("from %s", corner)
          .anyMatch(lane -> BruteOutline.distance(point, lane) <= swath / 2 + PROMISED);
    }
  }
}
