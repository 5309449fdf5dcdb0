package org.dfra.behaviors.perceptual.mines;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.dfra.behaviors.perceptual.mines.DetectionWindow.WindowGrid;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination.BayesCombination;
import org.dfra.behaviors.perceptual.mines.ImageMineDetector.ImageDetections;
import org.dfra.behaviors.perceptual.mines.MineCandidateMap.CandidateEstimate;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.behaviors.perceptual.mines.MineObservation.Viewpoint;
import org.dfra.behaviors.perceptual.mines.RepeatedDetectionRates.DetectorRates;
import org.dfra.flow.sensor.CameraImage.Band;
import org.junit.jupiter.api.Test;

class MineCandidateMapTest {

  private static final double PRIOR = 0.1;
  private static final RepeatedDetectionRates LIGHT =
      new RepeatedDetectionRates(
          new DetectorRates(0.8, 0.1, 1),
          new DetectorRates(0.9, 0.6, 1),
          new DetectorRates(0.3, 0.05, 1));
  private static final RepeatedDetectionRates HEAT =
      new RepeatedDetectionRates(
          new DetectorRates(0.7, 0.2, 1),
          new DetectorRates(0.9, 0.5, 1),
          new DetectorRates(0.2, 0.1, 1));
  private static final GroundPoint AHEAD = new GroundPoint(2.6, 0);

  private final EvidenceCombination fusion = new BayesCombination(PRIOR);
  private final MineCandidateMap places =
      new MineCandidateMap(fusion, Map.of(Band.VISIBLE, LIGHT, Band.THERMAL, HEAT), 0.5, 0.5);

  private static final WindowGrid WINDOWS =
      new WindowGrid(Ground.CAMERA, ImageMineDetectorSettings.DEFAULT.target(), 0.9, 3.5);

  private static MineObservation.LocatedDetections view(
      Band band, double east, GroundPoint... onMap) {
    Viewpoint from = new Viewpoint(east, 0, 0);
    List<GroundPoint> found = Arrays.stream(onMap).map(from::toBase).toList();
    return new MineObservation.LocatedDetections(from, new ImageDetections(band, WINDOWS, found));
  }

  private CandidateEstimate only() {
    assertThat(places.candidates(0)).hasSize(1);
    return places.candidates(0).get(0);
  }

  /** Odds of a mine by the likelihood ratios of what was seen. */
  private static double probability(double... ratios) {
    double odds = PRIOR / (1 - PRIOR);
    for (double each : ratios) {
      odds *= each;
    }
    return odds / (1 + odds);
  }

  @Test
  void bothCamerasCount() {
    places.add(
        new MineObservation(List.of(view(Band.VISIBLE, 0, AHEAD), view(Band.THERMAL, 0, AHEAD))));
    assertThat(only().probability()).isCloseTo(probability(8, 3.5), within(1e-9));
    assertThat(only().observations()).as("a pair is one look").isEqualTo(1);
  }

  @Test
  void silenceOfOneCountsAgainst() {
    places.add(new MineObservation(List.of(view(Band.VISIBLE, 0, AHEAD), view(Band.THERMAL, 0))));
    // 0.3 of the mines are silent in heat, and 0.8 of all else
    assertThat(only().probability()).isCloseTo(probability(8, 0.3 / 0.8), within(1e-9));
  }

  @Test
  void theSameLookTwiceCountsOnce() {
    for (int i = 0; i < 3; i++) {
      places.add(new MineObservation(List.of(view(Band.VISIBLE, 0.1 * i, AHEAD))));
    }
    assertThat(only().probability()).isCloseTo(probability(8), within(1e-9));
    assertThat(only().observations()).isEqualTo(1);
  }

  @Test
  void aLookFromElsewhereCountsAsOneThatRepeats() {
    places.add(new MineObservation(List.of(view(Band.VISIBLE, 0, AHEAD))));
    places.add(new MineObservation(List.of(view(Band.VISIBLE, 0.5, AHEAD))));
    assertThat(only().probability()).isCloseTo(probability(8, 0.9 / 0.6), within(1e-9));
    places.add(new MineObservation(List.of(view(Band.VISIBLE, 1))));
    assertThat(only().probability()).isCloseTo(probability(8, 0.9 / 0.6, 0.1 / 0.4), within(1e-9));
    places.add(new MineObservation(List.of(view(Band.VISIBLE, 0, AHEAD))));
    assertThat(only().observations()).as("from where it looked first").isEqualTo(2);
  }

  @Test
  void silenceBeforeTheFirstAlarmCountsToo() {
    places.add(new MineObservation(List.of(view(Band.VISIBLE, 0))));
    places.add(new MineObservation(List.of(view(Band.VISIBLE, 0.5, AHEAD))));
    assertThat(only().probability()).isCloseTo(probability(0.2 / 0.9, 0.3 / 0.05), within(1e-9));
  }

  @Test
  void whatIsNotInViewSaysNothing() {
    places.add(new MineObservation(List.of(view(Band.VISIBLE, 0, AHEAD))));
    places.add(new MineObservation(List.of(view(Band.VISIBLE, 5))));
    assertThat(only().probability()).isCloseTo(probability(8), within(1e-9));
  }

  @Test
  void whatIsNearIsTheSamePlaceAndWhatIsFarAnother() {
    places.add(new MineObservation(List.of(view(Band.VISIBLE, 0, AHEAD))));
    places.add(new MineObservation(List.of(view(Band.VISIBLE, 0.5, new GroundPoint(2.8, 0)))));
    assertThat(only().position().distance(new GroundPoint(2.7, 0))).isLessThan(1e-9);
    places.add(
        new MineObservation(List.of(view(Band.VISIBLE, 1, AHEAD, new GroundPoint(3.5, 0.3)))));
    assertThat(places.candidates(0)).hasSize(2);
    assertThat(places.candidates(0))
        .isSortedAccordingTo((a, b) -> Double.compare(b.probability(), a.probability()));
  }
}
