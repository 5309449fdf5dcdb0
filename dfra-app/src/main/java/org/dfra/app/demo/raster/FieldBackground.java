package org.dfra.app.demo.raster;

import java.util.ArrayList;
import java.util.List;
import org.dfra.app.demo.map.FieldMap;
import org.dfra.app.plot.Series;
import org.dfra.app.raster.Scenario;
import org.dfra.behaviors.raster.Lane;
import org.dfra.geometry.LocalFrame;

/** The searched region and its lanes, as series in the region's frame. */
final class FieldBackground {

  private FieldBackground() {}

  /** To be drawn first. */
  static List<Series> of(Scenario scenario) {
    LocalFrame frame = scenario.region().frame();
    Series region =
        FieldMap.outline("", scenario.region().corners().stream().map(frame::toLocal).toList());
    List<Double> x = new ArrayList<>();
    List<Double> y = new ArrayList<>();
    for (Lane lane : scenario.plan().lanes()) {
      x.addAll(List.of(lane.from().east(), lane.to().east(), lane.to().east()));
      y.addAll(List.of(lane.from().north(), lane.to().north(), Double.NaN)); // lanes do not join
    }
    return List.of(region.faint(), Series.line("", array(x), array(y)).faint());
  }

  private static double[] array(List<Double> all) {
    return all.stream().mapToDouble(Double::doubleValue).toArray();
  }
}
