package org.dfra.app.mines;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dfra.app.mines.MineLane.LaneLook;
import org.dfra.behaviors.perceptual.mines.Fusion;
import org.dfra.behaviors.perceptual.mines.Look;
import org.dfra.behaviors.perceptual.mines.Opinion;
import org.dfra.behaviors.perceptual.mines.Places;
import org.dfra.behaviors.perceptual.mines.Places.Candidate;
import org.dfra.behaviors.perceptual.mines.Repeated;
import org.dfra.behaviors.perceptual.mines.Repeated.Before;
import org.dfra.behaviors.perceptual.mines.Spot;
import org.dfra.flow.sensor.CameraImage.Band;

/**
 * Counts how well both cameras do together: in a first look alone, where an alarm is a probability
 * of {@value #ALARM} or more, and after the whole lane, where it is {@value #SURE} or more.
 */
public final class FusedTally {

  private static final double ALARM = 0.5;
  private static final double SURE = 0.8;
  private static final double SPACING = 0.5; // metres from look to look

  private final Fusion fusion;
  private final Map<Band, Repeated> rates;
  private final Rate mines = new Rate();
  private final Rate clear = new Rate();
  private final Rate found = new Rate();
  private final Rate mistaken = new Rate();
  private final List<Double> errors = new ArrayList<>();

  /** With rates that were measured elsewhere. */
  public FusedTally(Fusion fusion, Map<Band, Repeated> rates) {
    this.fusion = fusion;
    this.rates = rates;
  }

  /** Looks at a mine after which there is an alarm. */
  public Rate mines() {
    return mines;
  }

  /** Looks at a place without a mine after which there is an alarm. */
  public Rate clear() {
    return clear;
  }

  /** Mines that are found in the end, of those that both cameras ever saw. */
  public Rate found() {
    return found;
  }

  /** What is found in the end and is no mine, of all that is found. */
  public Rate mistaken() {
    return mistaken;
  }

  /** How far what was found is from its mine, root mean square, metres. */
  public double error() {
    return Math.sqrt(errors.stream().mapToDouble(e -> e * e).average().orElse(Double.NaN));
  }

  /** Counts a lane. */
  public void add(MineLane lane) {
    Places places = new Places(fusion, rates, Tally.GATE, SPACING);
    Map<String, Spot> seen = new HashMap<>();
    for (LaneLook each : lane.looks()) {
      once(lane, each);
      places.take(each.look());
      lane.mines()
          .forEach(
              (name, spot) -> {
                if (each.look().views().stream().allMatch(view -> each.shows(view, name, spot))) {
                  seen.put(name, spot);
                }
              });
    }
    inTheEnd(lane, places, seen);
  }

  private void inTheEnd(MineLane lane, Places places, Map<String, Spot> seen) {
    List<Candidate> candidates = places.candidates(SURE);
    for (Spot mine : seen.values()) {
      double nearest =
          candidates.stream()
              .mapToDouble(candidate -> candidate.place().distance(mine))
              .min()
              .orElse(Double.POSITIVE_INFINITY);
      found.count(nearest <= Tally.GATE);
      if (nearest <= Tally.GATE) {
        errors.add(nearest);
      }
    }
    for (Candidate each : candidates) {
      mistaken.count(
          lane.mines().values().stream()
              .allMatch(mine -> mine.distance(each.place()) > Tally.GATE));
    }
  }

  /** One look by itself. */
  private void once(MineLane lane, LaneLook look) {
    lane.mines()
        .forEach(
            (name, spot) -> {
              boolean isShown =
                  look.look().views().stream().anyMatch(view -> look.shows(view, name, spot));
              if (isShown) {
                mines.count(isAlarm(look.look(), spot));
              }
            });
    List<Spot> clutter = new ArrayList<>();
    for (Look.View view : look.look().views()) {
      for (Spot each : view.found()) {
        if (isClear(lane, each)
            && clutter.stream().noneMatch(c -> c.distance(each) <= Tally.GATE)) {
          clutter.add(each);
          clear.count(isAlarm(look.look(), each));
        }
      }
    }
    Set<Spot> squares = new HashSet<>();
    look.look().views().forEach(view -> squares.addAll(Tally.squaresIn(view)));
    for (Spot square : squares) {
      if (isClear(lane, square)
          && clutter.stream().noneMatch(c -> c.distance(square) <= Tally.GATE)) {
        clear.count(false);
      }
    }
  }

  private static boolean isClear(MineLane lane, Spot spot) {
    return lane.mines().values().stream().allMatch(mine -> mine.distance(spot) > Tally.GATE);
  }

  private boolean isAlarm(Look look, Spot spot) {
    Opinion opinion = fusion.nothing();
    for (Look.View view : look.views()) {
      boolean alarm = view.found().stream().anyMatch(each -> each.distance(spot) <= Tally.GATE);
      Repeated repeated = rates.get(view.glance().band());
      if (repeated != null && (alarm || view.sees(spot))) {
        opinion =
            fusion.combine(opinion, fusion.of(repeated.evidence(Before.NOTHING, alarm))).opinion();
      }
    }
    return fusion.probability(opinion) >= ALARM;
  }
}
