package org.dfra.app.mines;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dfra.app.mines.MineLane.LaneLook;
import org.dfra.behaviors.perceptual.mines.DetectorRates;
import org.dfra.behaviors.perceptual.mines.Look;
import org.dfra.behaviors.perceptual.mines.Repeated;
import org.dfra.behaviors.perceptual.mines.Repeated.Before;
import org.dfra.behaviors.perceptual.mines.Spot;
import org.dfra.flow.sensor.CameraImage.Band;

/**
 * Counts how often a camera's looks at mines raise an alarm, and its looks at places without one,
 * by what its look before at the same place said.
 *
 * <p>A place without a mine is a square of {@value #SQUARE} m, as large as the circle of the gate
 * in which things found are taken for one. Where something was found that is no mine the circle
 * around it is followed instead, look by look.
 */
public final class Tally {

  /** How far from a mine an alarm is its own, metres; the detector's gate. */
  public static final double GATE = 0.5;

  private static final double SQUARE = 0.886; // metres: √π · GATE

  private final Band band;
  private final Map<Before, Rate> mines = new EnumMap<>(Before.class);
  private final Map<Before, Rate> clear = new EnumMap<>(Before.class);

  /** Of the cameras of a band. */
  public Tally(Band band) {
    this.band = band;
    for (Before each : Before.values()) {
      mines.put(each, new Rate());
      clear.put(each, new Rate());
    }
  }

  /** Alarms at mines by what the look before said. */
  public Rate mines(Before before) {
    return mines.getOrDefault(before, new Rate());
  }

  /** Alarms where there is no mine by what the look before said. */
  public Rate clear(Before before) {
    return clear.getOrDefault(before, new Rate());
  }

  /** All rates as a detector takes them. */
  public Repeated rates() {
    return new Repeated(rates(Before.NOTHING), rates(Before.ALARM), rates(Before.SILENCE));
  }

  private DetectorRates rates(Before before) {
    return new DetectorRates(mines(before).value(), clear(before).value(), 1);
  }

  /** Counts a lane. */
  public void add(MineLane lane) {
    new Pass(lane).count();
  }

  /** A lane being counted. */
  private final class Pass {
    private final MineLane lane;
    private final Map<String, Before> atMines = new HashMap<>();
    private final List<Spot> clutter = new ArrayList<>();
    private final Map<Spot, Before> atClutter = new HashMap<>();
    private final Set<Spot> squaresSeen = new HashSet<>();

    Pass(MineLane lane) {
      this.lane = lane;
    }

    void count() {
      for (LaneLook look : lane.looks()) {
        for (Look.View view : look.look().views()) {
          if (view.glance().band() == band) {
            mines(look, view);
            clutter(view);
          }
        }
      }
    }

    private void mines(LaneLook look, Look.View view) {
      lane.mines()
          .forEach(
              (name, spot) -> {
                if (look.shows(view, name, spot)) {
                  boolean alarm =
                      view.found().stream().anyMatch(found -> found.distance(spot) <= GATE);
                  Before before = atMines.getOrDefault(name, Before.NOTHING);
                  Tally.this.mines(before).count(alarm);
                  atMines.put(name, Before.of(alarm));
                }
              });
    }

    private void clutter(Look.View view) {
      List<Spot> found = view.found().stream().filter(this::isClear).toList();
      Set<Spot> alarmed = new HashSet<>();
      List<Spot> fresh = new ArrayList<>();
      for (Spot each : found) {
        Optional<Spot> known = clutter.stream().filter(c -> c.distance(each) <= GATE).findFirst();
        known.ifPresentOrElse(alarmed::add, () -> fresh.add(each));
      }
      for (Spot each : clutter) {
        if (alarmed.contains(each) || view.sees(each)) {
          Tally.this
              .clear(atClutter.getOrDefault(each, Before.NOTHING))
              .count(alarmed.contains(each));
          atClutter.put(each, Before.of(alarmed.contains(each)));
        }
      }
      for (Spot each : fresh) {
        boolean isFirst = !squaresSeen.contains(square(each));
        Tally.this.clear(isFirst ? Before.NOTHING : Before.SILENCE).add(1, 1);
        clutter.add(each);
        atClutter.put(each, Before.ALARM);
      }
      squares(view);
    }

    /** Counts the squares in view where nothing ever was found. */
    private void squares(Look.View view) {
      for (Spot square : squaresIn(view)) {
        if (isClear(square) && clutter.stream().noneMatch(c -> c.distance(square) <= GATE)) {
          boolean isFirst = squaresSeen.add(square);
          Tally.this.clear(isFirst ? Before.NOTHING : Before.SILENCE).count(false);
        }
      }
    }

    private boolean isClear(Spot spot) {
      return lane.mines().values().stream().allMatch(mine -> mine.distance(spot) > GATE);
    }
  }

  private static Spot square(Spot spot) {
    return new Spot(SQUARE * Math.rint(spot.x() / SQUARE), SQUARE * Math.rint(spot.y() / SQUARE));
  }

  /** The middles of the squares that a camera would see a mine in the middle of. */
  static List<Spot> squaresIn(Look.View view) {
    int reach = (int) Math.ceil(5 / SQUARE);
    Spot middle = square(new Spot(view.from().east(), view.from().north()));
    List<Spot> squares = new ArrayList<>();
    for (int i = -reach; i <= reach; i++) {
      for (int j = -reach; j <= reach; j++) {
        Spot square = square(new Spot(middle.x() + i * SQUARE, middle.y() + j * SQUARE));
        if (view.sees(square)) {
          squares.add(square);
        }
      }
    }
    return squares;
  }
}
