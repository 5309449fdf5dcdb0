package org.dfra.experiments.mines;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination;
import org.dfra.behaviors.perceptual.mines.EvidenceCombination.Opinion;
import org.dfra.behaviors.perceptual.mines.MineCandidateMap;
import org.dfra.behaviors.perceptual.mines.MineCandidateMap.CandidateEstimate;
import org.dfra.behaviors.perceptual.mines.MineObservation;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.behaviors.perceptual.mines.RepeatedDetectionRates;
import org.dfra.behaviors.perceptual.mines.RepeatedDetectionRates.PreviousResult;
import org.dfra.experiments.mines.DetectionCounter.DetectionRate;
import org.dfra.experiments.mines.MineLaneObservations.LaneObservation;
import org.dfra.flow.sensor.CameraImage.Band;

/**
 * Counts the results of both cameras together: for a single image, where an alarm is a probability
 * of {@value #ALARM} or more, and after the whole lane, where it is {@value #SURE} or more.
 */
public final class FusedDetectionCounter {

  private static final double ALARM = 0.5;
  private static final double SURE = 0.8;
  private static final double SPACING = 0.5; // metres between images

  private final EvidenceCombination fusion;
  private final Map<Band, RepeatedDetectionRates> rates;
  private final DetectionRate mines = new DetectionRate();
  private final DetectionRate clear = new DetectionRate();
  private final DetectionRate found = new DetectionRate();
  private final DetectionRate mistaken = new DetectionRate();
  private final List<Double> errors = new ArrayList<>();

  /** With rates that were measured before. */
  public FusedDetectionCounter(
      EvidenceCombination fusion, Map<Band, RepeatedDetectionRates> rates) {
    this.fusion = fusion;
    this.rates = rates;
  }

  /** Images of a mine that lead to an alarm. */
  public DetectionRate truePositives() {
    return mines;
  }

  /** Images of a place without a mine that lead to an alarm. */
  public DetectionRate falsePositives() {
    return clear;
  }

  /** Mines found after the whole lane, of those that both cameras ever saw. */
  public DetectionRate recall() {
    return found;
  }

  /** False detections after the whole lane, of all detections. */
  public DetectionRate falseDiscoveries() {
    return mistaken;
  }

  /** Position error of the found mines, root mean square, metres. */
  public double positionRmse() {
    return Math.sqrt(errors.stream().mapToDouble(e -> e * e).average().orElse(Double.NaN));
  }

  /** Counts a lane. */
  public void add(MineLaneObservations lane) {
    MineCandidateMap places = new MineCandidateMap(fusion, rates, DetectionCounter.GATE, SPACING);
    Map<String, GroundPoint> seen = new HashMap<>();
    for (LaneObservation each : lane.observations()) {
      once(lane, each);
      places.add(each.observation());
      lane.mines()
          .forEach(
              (name, spot) -> {
                if (each.observation().views().stream()
                    .allMatch(view -> each.shows(view, name, spot))) {
                  seen.put(name, spot);
                }
              });
    }
    inTheEnd(lane, places, seen);
  }

  private void inTheEnd(
      MineLaneObservations lane, MineCandidateMap places, Map<String, GroundPoint> seen) {
    List<CandidateEstimate> candidates = places.candidates(SURE);
    for (GroundPoint mine : seen.values()) {
      double nearest =
          candidates.stream()
              .mapToDouble(candidate -> candidate.position().distance(mine))
              .min()
              .orElse(Double.POSITIVE_INFINITY);
      found.count(nearest <= DetectionCounter.GATE);
      if (nearest <= DetectionCounter.GATE) {
        errors.add(nearest);
      }
    }
    for (CandidateEstimate each : candidates) {
      mistaken.count(
          lane.mines().values().stream()
              .allMatch(mine -> mine.distance(each.position()) > DetectionCounter.GATE));
    }
  }

  /** A single image by itself. */
  private void once(MineLaneObservations lane, LaneObservation look) {
    lane.mines()
        .forEach(
            (name, spot) -> {
              boolean isShown =
                  look.observation().views().stream()
                      .anyMatch(view -> look.shows(view, name, spot));
              if (isShown) {
                mines.count(isAlarm(look.observation(), spot));
              }
            });
    List<GroundPoint> clutter = new ArrayList<>();
    for (MineObservation.LocatedDetections view : look.observation().views()) {
      for (GroundPoint each : view.points()) {
        if (isClear(lane, each)
            && clutter.stream().noneMatch(c -> c.distance(each) <= DetectionCounter.GATE)) {
          clutter.add(each);
          clear.count(isAlarm(look.observation(), each));
        }
      }
    }
    Set<GroundPoint> squares = new HashSet<>();
    look.observation().views().forEach(view -> squares.addAll(DetectionCounter.squaresIn(view)));
    for (GroundPoint square : squares) {
      if (isClear(lane, square)
          && clutter.stream().noneMatch(c -> c.distance(square) <= DetectionCounter.GATE)) {
        clear.count(false);
      }
    }
  }

  private static boolean isClear(MineLaneObservations lane, GroundPoint spot) {
    return lane.mines().values().stream()
        .allMatch(mine -> mine.distance(spot) > DetectionCounter.GATE);
  }

  private boolean isAlarm(MineObservation look, GroundPoint spot) {
    Opinion opinion = fusion.uninformed();
    for (MineObservation.LocatedDetections view : look.views()) {
      boolean alarm =
          view.points().stream().anyMatch(each -> each.distance(spot) <= DetectionCounter.GATE);
      RepeatedDetectionRates repeated = rates.get(view.detections().band());
      if (repeated != null && (alarm || view.covers(spot))) {
        opinion =
            fusion
                .combine(opinion, fusion.opinionOf(repeated.evidence(PreviousResult.NONE, alarm)))
                .opinion();
      }
    }
    return fusion.probability(opinion) >= ALARM;
  }
}
