package org.dfra.behaviors.perceptual.mines;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.dfra.behaviors.perceptual.mines.Repeated.Before;
import org.dfra.flow.sensor.CameraImage.Band;

/** Somewhere on the map that looked like a mine at least once. Confined to one thread. */
final class Place {

  /** σ of where a camera sees a mine, metres; of heat the shadow beside a mine draws it away. */
  private static final Map<Band, Double> SIGMA = Map.of(Band.VISIBLE, 0.1, Band.THERMAL, 0.25);

  private final Fusion fusion;
  private final Map<Band, Repeated> rates;
  private final Map<Band, Before> before = new EnumMap<>(Band.class);
  private final Map<Band, List<Viewpoint>> counted = new EnumMap<>(Band.class);
  private Spot middle;
  private double weight; // of all that was seen there
  private Opinion opinion;
  private int looks;

  Place(Spot first, Fusion fusion, Map<Band, Repeated> rates) {
    this.middle = first;
    this.fusion = fusion;
    this.rates = rates;
    this.opinion = fusion.nothing();
  }

  Spot middle() {
    return middle;
  }

  /** How likely there is a mine, 0 to 1. */
  double probability() {
    return fusion.probability(opinion);
  }

  /** In how many looks something was seen there. */
  int looks() {
    return looks;
  }

  /** One look more has seen something there. */
  void seen() {
    looks++;
  }

  /** Whether a camera has not yet looked at it from within so many metres of there. */
  boolean isNew(Band band, Viewpoint from, double spacing) {
    return counted.getOrDefault(band, List.of()).stream()
        .noneMatch(other -> other.distance(from) < spacing);
  }

  /** A camera has seen something there. */
  void alarm(Band band, Viewpoint from, Spot at) {
    double more = 1 / Math.pow(SIGMA.getOrDefault(band, 1.0), 2);
    double part = more / (weight + more);
    middle =
        new Spot(
            middle.x() + part * (at.x() - middle.x()), middle.y() + part * (at.y() - middle.y()));
    weight += more;
    count(band, from, true);
  }

  /** A camera has seen nothing there. */
  void silence(Band band, Viewpoint from) {
    count(band, from, false);
  }

  private void count(Band band, Viewpoint from, boolean isAlarm) {
    Repeated repeated = rates.get(band);
    if (repeated == null) {
      throw new IllegalStateException("no rates of a camera of band " + band);
    }
    Evidence evidence = repeated.evidence(before.getOrDefault(band, Before.NOTHING), isAlarm);
    opinion = fusion.combine(opinion, fusion.of(evidence)).opinion();
    before.put(band, Before.of(isAlarm));
    counted.computeIfAbsent(band, unused -> new ArrayList<>()).add(from);
  }
}
