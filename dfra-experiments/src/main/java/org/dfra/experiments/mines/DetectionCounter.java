package org.dfra.experiments.mines;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dfra.behaviors.perceptual.mines.MineObservation;
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.behaviors.perceptual.mines.RepeatedDetectionRates;
import org.dfra.behaviors.perceptual.mines.RepeatedDetectionRates.DetectorRates;
import org.dfra.behaviors.perceptual.mines.RepeatedDetectionRates.PreviousResult;
import org.dfra.experiments.mines.MineLaneObservations.LaneObservation;
import org.dfra.experiments.navigation.ConfidenceInterval;
import org.dfra.flow.sensor.CameraImage.Band;

/**
 * Counts how often a camera raises an alarm at mines and at places without a mine, separately by
 * the result of its previous image of the same place.
 *
 * <p>A place without a mine is a square of {@value #SQUARE} m, with the area of the circular gate
 * in which detections are associated. If a false alarm occurs, the circle around it is tracked
 * instead, image by image.
 */
public final class DetectionCounter {

  /** Maximum distance between a mine and its alarm, metres; the detector's gate. */
  public static final double GATE = 0.5;

  private static final double SQUARE = 0.886; // metres: √π · GATE

  private final Band band;
  private final Map<PreviousResult, DetectionRate> mines = new EnumMap<>(PreviousResult.class);
  private final Map<PreviousResult, DetectionRate> clear = new EnumMap<>(PreviousResult.class);

  /** Counts for the cameras of a band. */
  public DetectionCounter(Band band) {
    this.band = band;
    for (PreviousResult each : PreviousResult.values()) {
      mines.put(each, new DetectionRate());
      clear.put(each, new DetectionRate());
    }
  }

  /** Alarms at mines, given the previous result. */
  public DetectionRate truePositives(PreviousResult before) {
    return mines.getOrDefault(before, new DetectionRate());
  }

  /** Alarms where there is no mine, given the previous result. */
  public DetectionRate falsePositives(PreviousResult before) {
    return clear.getOrDefault(before, new DetectionRate());
  }

  /** All rates in the form for a detector. */
  public RepeatedDetectionRates rates() {
    return new RepeatedDetectionRates(
        rates(PreviousResult.NONE), rates(PreviousResult.ALARM), rates(PreviousResult.NO_ALARM));
  }

  private DetectorRates rates(PreviousResult before) {
    return new DetectorRates(truePositives(before).value(), falsePositives(before).value(), 1);
  }

  /** Counts a lane. */
  public void add(MineLaneObservations lane) {
    new LaneCounter(lane).count();
  }

  /** Counts one lane. */
  private final class LaneCounter {
    private final MineLaneObservations lane;
    private final Map<String, PreviousResult> atMines = new HashMap<>();
    private final List<GroundPoint> clutter = new ArrayList<>();
    private final Map<GroundPoint, PreviousResult> atClutter = new HashMap<>();
    private final Set<GroundPoint> squaresSeen = new HashSet<>();

    LaneCounter(MineLaneObservations lane) {
      this.lane = lane;
    }

    void count() {
      for (LaneObservation look : lane.observations()) {
        for (MineObservation.LocatedDetections view : look.observation().views()) {
          if (view.detections().band() == band) {
            mines(look, view);
            clutter(view);
          }
        }
      }
    }

    private void mines(LaneObservation look, MineObservation.LocatedDetections view) {
      lane.mines()
          .forEach(
              (name, spot) -> {
                if (look.shows(view, name, spot)) {
                  boolean alarm =
                      view.points().stream().anyMatch(found -> found.distance(spot) <= GATE);
                  PreviousResult before = atMines.getOrDefault(name, PreviousResult.NONE);
                  DetectionCounter.this.truePositives(before).count(alarm);
                  atMines.put(name, PreviousResult.of(alarm));
                }
              });
    }

    private void clutter(MineObservation.LocatedDetections view) {
      List<GroundPoint> found = view.points().stream().filter(this::isClear).toList();
      Set<GroundPoint> alarmed = new HashSet<>();
      List<GroundPoint> fresh = new ArrayList<>();
      for (GroundPoint each : found) {
        Optional<GroundPoint> known =
            clutter.stream().filter(c -> c.distance(each) <= GATE).findFirst();
        known.ifPresentOrElse(alarmed::add, () -> fresh.add(each));
      }
      for (GroundPoint each : clutter) {
        if (alarmed.contains(each) || view.covers(each)) {
          DetectionCounter.this
              .falsePositives(atClutter.getOrDefault(each, PreviousResult.NONE))
              .count(alarmed.contains(each));
          atClutter.put(each, PreviousResult.of(alarmed.contains(each)));
        }
      }
      for (GroundPoint each : fresh) {
        boolean isFirst = !squaresSeen.contains(square(each));
        DetectionCounter.this
            .falsePositives(isFirst ? PreviousResult.NONE : PreviousResult.NO_ALARM)
            .add(1, 1);
        clutter.add(each);
        atClutter.put(each, PreviousResult.ALARM);
      }
      squares(view);
    }

    /** Counts the squares in view where nothing has been detected. */
    private void squares(MineObservation.LocatedDetections view) {
      for (GroundPoint square : squaresIn(view)) {
        if (isClear(square) && clutter.stream().noneMatch(c -> c.distance(square) <= GATE)) {
          boolean isFirst = squaresSeen.add(square);
          DetectionCounter.this
              .falsePositives(isFirst ? PreviousResult.NONE : PreviousResult.NO_ALARM)
              .count(false);
        }
      }
    }

    private boolean isClear(GroundPoint spot) {
      return lane.mines().values().stream().allMatch(mine -> mine.distance(spot) > GATE);
    }
  }

  private static GroundPoint square(GroundPoint spot) {
    return new GroundPoint(
        SQUARE * Math.rint(spot.x() / SQUARE), SQUARE * Math.rint(spot.y() / SQUARE));
  }

  /** The centres of the squares in which the camera would see a mine. */
  static List<GroundPoint> squaresIn(MineObservation.LocatedDetections view) {
    int reach = (int) Math.ceil(5 / SQUARE);
    GroundPoint middle = square(new GroundPoint(view.viewpoint().east(), view.viewpoint().north()));
    List<GroundPoint> squares = new ArrayList<>();
    for (int i = -reach; i <= reach; i++) {
      for (int j = -reach; j <= reach; j++) {
        GroundPoint square =
            square(new GroundPoint(middle.x() + i * SQUARE, middle.y() + j * SQUARE));
        if (view.covers(square)) {
          squares.add(square);
        }
      }
    }
    return squares;
  }

  /** The frequency of an event among its trials. Mutable, confined to one thread. */
  public static final class DetectionRate {

    private int times;
    private int trials;

    void count(boolean happened) {
      trials++;
      times += happened ? 1 : 0;
    }

    void add(int moreTimes, int moreTrials) {
      times += moreTimes;
      trials += moreTrials;
    }

    /** Number of events. */
    public int times() {
      return times;
    }

    /** Number of trials. */
    public int trials() {
      return trials;
    }

    /**
     * The estimated rate: half an event is added to both outcomes, so that it is never 0 or 1,
     * which would mean certainty (the mean of Jeffreys' posterior); rounded to four decimals.
     */
    public double value() {
      double rate = (times + 0.5) / (trials + 1);
      return Math.max(1e-4, Math.min(1 - 1e-4, Math.rint(rate * 1e4) / 1e4));
    }

    /** Its Wilson interval of 95 %, around the observed share. */
    public ConfidenceInterval interval() {
      return trials == 0
          ? new ConfidenceInterval(Double.NaN, 0, 1)
          : ConfidenceInterval.ofProportion(times, trials);
    }
  }
}
