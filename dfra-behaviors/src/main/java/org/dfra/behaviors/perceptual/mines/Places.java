package org.dfra.behaviors.perceptual.mines;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dfra.flow.sensor.CameraImage.Band;

/**
 * All places that looked like a mine at least once, and what every look since, and the last {@value
 * #REMEMBERED} before, says of them. Confined to one thread.
 *
 * <pre>
 *   look --&gt; each thing found --&gt; the nearest place within the gate, or a new one: alarm
 *        '-&gt; each place in view where nothing was found: silence
 * </pre>
 *
 * <p>A camera's look at a place counts only if it is from elsewhere than all its looks at it that
 * counted before.
 */
public final class Places {

  /** Looks that a new place is judged by besides. */
  private static final int REMEMBERED = 200;

  /** With more the least likely are forgotten. */
  private static final int MOST = 2000;

  /** Less than the spacing by this much is still elsewhere: positions are not exact. */
  private static final double ALMOST = 0.9;

  private final Fusion fusion;
  private final Map<Band, Repeated> rates;
  private final double gate;
  private final double spacing;
  private final List<Place> places = new ArrayList<>();
  private final Deque<Look> past = new ArrayDeque<>();

  /**
   * @param rates of the cameras that looks are from
   * @param gate how far from a place what is seen belongs to it, metres
   * @param spacing from where looks at a place are taken, at least, metres
   */
  public Places(Fusion fusion, Map<Band, Repeated> rates, double gate, double spacing) {
    this.fusion = fusion;
    this.rates = Map.copyOf(rates);
    this.gate = gate;
    this.spacing = ALMOST * spacing;
  }

  /**
   * A place as it is believed to be now.
   *
   * @param place x east, y north on the map
   * @param probability that there is a mine, 0 to 1
   * @param looks in which something was seen there
   */
  public record Candidate(Spot place, double probability, int looks) {}

  /** Takes what was seen; in the order in which it was seen. */
  public void take(Look look) {
    Set<Place> seen = new HashSet<>();
    for (Look.View view : look.views()) {
      take(view, seen);
    }
    seen.forEach(Place::seen);
    past.addLast(look);
    if (past.size() > REMEMBERED) {
      past.removeFirst();
    }
    if (places.size() > MOST) {
      places.sort(Comparator.comparingDouble(place -> -place.probability()));
      places.subList(MOST / 2, places.size()).clear();
    }
  }

  private void take(Look.View view, Set<Place> seen) {
    Band band = view.glance().band();
    Set<Place> alarmed = new HashSet<>();
    for (Spot found : view.found()) {
      Place place = nearest(found).orElseGet(() -> begin(found));
      if (alarmed.add(place) && place.isNew(band, view.from(), spacing)) {
        place.alarm(band, view.from(), found);
        seen.add(place);
      }
    }
    for (Place place : places) {
      if (!alarmed.contains(place)) {
        silence(place, view);
      }
    }
  }

  private void silence(Place place, Look.View view) {
    Band band = view.glance().band();
    if (view.sees(place.middle()) && place.isNew(band, view.from(), spacing)) {
      place.silence(band, view.from());
    }
  }

  private Optional<Place> nearest(Spot spot) {
    return places.stream()
        .filter(place -> place.middle().distance(spot) <= gate)
        .min(Comparator.comparingDouble(place -> place.middle().distance(spot)));
  }

  /** A place where nothing was seen up to now, though some looks may have been at it. */
  private Place begin(Spot spot) {
    Place place = new Place(spot, fusion, rates);
    places.add(place);
    past.forEach(look -> look.views().forEach(view -> silence(place, view)));
    return place;
  }

  /** What is at least so likely a mine, the likeliest first. */
  public List<Candidate> candidates(double least) {
    return places.stream()
        .map(place -> new Candidate(place.middle(), place.probability(), place.looks()))
        .filter(candidate -> candidate.probability() >= least)
        .sorted(Comparator.comparingDouble(candidate -> -candidate.probability()))
        .toList();
  }
}
