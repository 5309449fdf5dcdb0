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
import org.dfra.behaviors.perceptual.mines.MineObservation.GroundPoint;
import org.dfra.flow.sensor.CameraImage.Band;

/**
 * All positions with at least one detection, with the evidence of every observation since, and of
 * the last {@value #REMEMBERED} before. Confined to one thread.
 *
 * <pre>
 *   observation --&gt; each detection --&gt; nearest candidate within the gate, or a new one: alarm
 *        '--------&gt; each candidate in view without a detection: no alarm
 * </pre>
 *
 * <p>A camera's observation of a candidate counts only if its viewpoint differs from those of all
 * its observations counted before.
 */
public final class MineCandidateMap {

  /** Number of earlier observations that a new candidate uses. */
  private static final int REMEMBERED = 200;

  /** Maximum number of candidates; the least likely are dropped. */
  private static final int MOST = 2000;

  /** Tolerance of the viewpoint spacing: positions are not exact. */
  private static final double ALMOST = 0.9;

  private final EvidenceCombination fusion;
  private final Map<Band, RepeatedDetectionRates> rates;
  private final double gate;
  private final double spacing;
  private final List<MineCandidate> places = new ArrayList<>();
  private final Deque<MineObservation> past = new ArrayDeque<>();

  /**
   * @param rates of the observing cameras
   * @param gate maximum distance of a detection from its candidate, metres
   * @param spacing minimum distance between viewpoints, metres
   */
  public MineCandidateMap(
      EvidenceCombination fusion,
      Map<Band, RepeatedDetectionRates> rates,
      double gate,
      double spacing) {
    this.fusion = fusion;
    this.rates = Map.copyOf(rates);
    this.gate = gate;
    this.spacing = ALMOST * spacing;
  }

  /**
   * The current estimate of a candidate.
   *
   * @param position x east, y north on the map
   * @param probability that there is a mine, 0 to 1
   * @param observations with a detection there
   */
  public record CandidateEstimate(GroundPoint position, double probability, int observations) {}

  /** Adds an observation; call it in the order of time. */
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

  /** A position without a detection so far, though earlier observations may include it. */
  private MineCandidate begin(GroundPoint spot) {
    MineCandidate place = new MineCandidate(spot, fusion, rates);
    places.add(place);
    past.forEach(look -> look.views().forEach(view -> silence(place, view)));
    return place;
  }

  /** Candidates with at least this probability, the likeliest first. */
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
