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
public final class MineCandidateMap {

  /** Looks that a new place is judged by besides. */
  private static final int REMEMBERED = 200;

  /** With more the least likely are forgotten. */
  private static final int MOST = 2000;

  /** Less than the spacing by this much is still elsewhere: positions are not exact. */
  private static final double ALMOST = 0.9;

  private final Fusion fusion;
  private final Map<Band, RepeatedDetectionRates> rates;
  private final double gate;
  private final double spacing;
  private final List<MineCandidate> places = new ArrayList<>();
  private final Deque<MineObservation> past = new ArrayDeque<>();

  /**
   * @param rates of the cameras that looks are from
   * @param gate how far from a place what is seen belongs to it, metres
   * @param spacing from where looks at a place are taken, at least, metres
   */
  public MineCandidateMap(
      Fusion fusion, Map<Band, RepeatedDetectionRates> rates, double gate, double spacing) {
    this.fusion = fusion;
    this.rates = Map.copyOf(rates);
    this.gate = gate;
    this.spacing = ALMOST * spacing;
  }

  /**
   * A place as it is believed to be now.
   *
   * @param position x east, y north on the map
   * @param probability that there is a mine, 0 to 1
   * @param observations in which something was seen there
   */
  public record CandidateEstimate(GroundPoint position, double probability, int observations) {}

  /** Takes what was seen; in the order in which it was seen. */
  public void add(MineObservation look) {
    Set<MineCandidate> seen = new HashSet<>();
    for (MineObservation.LocatedDetections view : look.views()) {
      add(view, seen);
    }
    seen.forEach(MineCandidate::countObservation);
    past.addLast(look);
    if (past.size() > REMEMBERED) {
      past.removeFirst();
    }
    if (places.size() > MOST) {
      places.sort(Comparator.comparingDouble(place -> -place.probability()));
      places.subList(MOST / 2, places.size()).clear();
    }
  }

  private void add(MineObservation.LocatedDetections view, Set<MineCandidate> seen) {
    Band band = view.detections().band();
    Set<MineCandidate> alarmed = new HashSet<>();
    for (GroundPoint found : view.points()) {
      MineCandidate place = nearest(found).orElseGet(() -> begin(found));
      if (alarmed.add(place) && place.isNewViewpoint(band, view.viewpoint(), spacing)) {
        place.recordAlarm(band, view.viewpoint(), found);
        seen.add(place);
      }
    }
    for (MineCandidate place : places) {
      if (!alarmed.contains(place)) {
        silence(place, view);
      }
    }
  }

  private void silence(MineCandidate place, MineObservation.LocatedDetections view) {
    Band band = view.detections().band();
    if (view.covers(place.position()) && place.isNewViewpoint(band, view.viewpoint(), spacing)) {
      place.recordNoAlarm(band, view.viewpoint());
    }
  }

  private Optional<MineCandidate> nearest(GroundPoint spot) {
    return places.stream()
        .filter(place -> place.position().distance(spot) <= gate)
        .min(Comparator.comparingDouble(place -> place.position().distance(spot)));
  }

  /** A place where nothing was seen up to now, though some looks may have been at it. */
  private MineCandidate begin(GroundPoint spot) {
    MineCandidate place = new MineCandidate(spot, fusion, rates);
    places.add(place);
    past.forEach(look -> look.views().forEach(view -> silence(place, view)));
    return place;
  }

  /** What is at least so likely a mine, the likeliest first. */
  public List<CandidateEstimate> candidates(double least) {
    return places.stream()
        .map(
            place ->
                new CandidateEstimate(place.position(), place.probability(), place.observations()))
        .filter(candidate -> candidate.probability() >= least)
        .sorted(Comparator.comparingDouble(candidate -> -candidate.probability()))
        .toList();
  }
}
