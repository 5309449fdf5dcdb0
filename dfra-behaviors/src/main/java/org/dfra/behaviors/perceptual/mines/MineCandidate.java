package org.dfra.behaviors.perceptual.mines;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination.Evidence;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination.Opinion;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.behaviors.perceptual.mines.MineObservation.Viewpoint;
import org.dfra.behaviors.perceptual.mines.RepeatedDetectionRates.PreviousResult;
import org.dfra.flow.sensor.CameraImage.Band;

/** A map position with at least one detection. Confined to one thread. */
final class MineCandidate {

  /**
   * σ of a detection's position, metres; in thermal images the shadow beside a mine displaces it.
   */
  private static final Map<Band, Double> SIGMA = Map.of(Band.VISIBLE, 0.1, Band.THERMAL, 0.25);

  private final EvidenceCombination fusion;
  private final Map<Band, RepeatedDetectionRates> rates;
  private final Map<Band, PreviousResult> before = new EnumMap<>(Band.class);
  private final Map<Band, List<Viewpoint>> counted = new EnumMap<>(Band.class);
  private GroundPoint middle;
  private double weight; // of all detections there
  private Opinion opinion;
  private int looks;

  MineCandidate(
      GroundPoint first, EvidenceCombination fusion, Map<Band, RepeatedDetectionRates> rates) {
    this.middle = first;
    this.fusion = fusion;
    this.rates = rates;
    this.opinion = fusion.uninformed();
  }

  GroundPoint position() {
    return middle;
  }

  /** Probability of a mine, 0 to 1. */
  double probability() {
    return fusion.probability(opinion);
  }

  /** Number of observations with a detection there. */
  int observations() {
    return looks;
  }

  /** Counts one more observation with a detection there. */
  void countObservation() {
    looks++;
  }

  /** Whether a camera has not yet observed it from within the given distance of that viewpoint. */
  boolean isNewViewpoint(Band band, Viewpoint from, double spacing) {
    return counted.getOrDefault(band, List.of()).stream()
        .noneMatch(other -> other.distance(from) < spacing);
  }

  /** Adds a camera's detection there. */
  void recordAlarm(Band band, Viewpoint from, GroundPoint at) {
    double more = 1 / Math.pow(SIGMA.getOrDefault(band, 1.0), 2);
    double part = more / (weight + more);
    middle =
        new GroundPoint(
            middle.x() + part * (at.x() - middle.x()), middle.y() + part * (at.y() - middle.y()));
    weight += more;
    count(band, from, true);
  }

  /** Adds a camera's observation without a detection there. */
  void recordNoAlarm(Band band, Viewpoint from) {
    count(band, from, false);
  }

  private void count(Band band, Viewpoint from, boolean isAlarm) {
    RepeatedDetectionRates repeated = rates.get(band);
    if (repeated == null) {
      throw new IllegalStateException("no detector rates for a camera of band " + band);
    }
    Evidence evidence = repeated.evidence(before.getOrDefault(band, PreviousResult.NONE), isAlarm);
    opinion = fusion.combine(opinion, fusion.opinionOf(evidence)).opinion();
    before.put(band, PreviousResult.of(isAlarm));
    counted.computeIfAbsent(band, unused -> new ArrayList<>()).add(from);
  }
}
