package org.dfra.cli.noise;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dfra.cli.noise.NoiseStudy.NoiseParameter;
import org.dfra.event.Reading;
import org.dfra.flow.sensor.RangeScan;

/**
 * Noise of the scans of a stopped laser in a static scene. Each beam has a usual range, the median
 * of its first scans. A reading nearer by {@link #NEARER} is a ghost, and lasts until a scan shows
 * none in that beam or its neighbours.
 */
final class LaserNoiseStudy implements NoiseStudy {

  /** Number of scans for the usual ranges. */
  private static final int LEARNED = 101;

  /** Metres. */
  private static final double NEARER = 0.5;

  /** Minimum number of beams between two ghosts. */
  private static final int GAP = 2;

  private final List<RangeScan> first = new ArrayList<>();
  private final List<Ghost> living = new ArrayList<>();
  private final SampleSeries lasted = new SampleSeries(); // seconds
  private double[] usual = {};
  private int nearest; // beam
  private final SampleSeries ranges = new SampleSeries(); // of the nearest beam
  private Instant begin = Instant.MIN;
  private Instant end = Instant.MIN;
  private long scans;
  private long ghostly;

  private static final class Ghost {
    private final Instant since;
    private int from;
    private int to;
    private boolean seen = true;

    Ghost(Instant since, int from, int to) {
      this.since = since;
      this.from = from;
      this.to = to;
    }

    boolean is(int otherFrom, int otherTo) {
      return otherFrom <= to + GAP && from <= otherTo + GAP;
    }
  }

  @Override
  public void add(Reading reading) {
    if (!(reading instanceof RangeScan scan)) {
      return;
    }
    scans++;
    if (first.size() < LEARNED) {
      first.add(scan);
      if (first.size() == LEARNED) {
        usual = usual();
        nearest = nearest();
        begin = scan.measured();
        end = begin;
      }
    } else if (scan.ranges().length == usual.length) {
      look(scan);
    }
  }

  /** The median range of each beam; infinite if it mostly had no echo. */
  private double[] usual() {
    int beams = first.get(0).ranges().length;
    double[] medians = new double[beams];
    for (int beam = 0; beam < beams; beam++) {
      double[] seen = new double[LEARNED];
      for (int i = 0; i < LEARNED; i++) {
        float[] row = first.get(i).ranges();
        seen[i] = beam < row.length ? row[beam] : Double.NaN;
      }
      Arrays.sort(seen); // failed measurements come last
      medians[beam] = seen[LEARNED / 2];
    }
    return medians;
  }

  /** The beam with the smallest usual range. */
  private int nearest() {
    int best = 0;
    for (int beam = 1; beam < usual.length; beam++) {
      if (usual[beam] > 0 && !(usual[best] > 0 && usual[best] <= usual[beam])) {
        best = beam;
      }
    }
    return best;
  }

  private void look(RangeScan scan) {
    float[] row = scan.ranges();
    float range = row[nearest];
    if (Float.isFinite(range) && Math.abs(range - usual[nearest]) < NEARER) {
      ranges.add(range);
    }
    living.forEach(each -> each.seen = false);
    boolean isGhostly = false;
    for (int beam = 0; beam < row.length; beam++) {
      if (!isNear(row, beam)) {
        continue;
      }
      int from = beam;
      while (beam + 1 < row.length && isNear(row, beam + 1)) {
        beam++;
      }
      isGhostly = true;
      note(scan.measured(), from, beam);
    }
    ghostly += isGhostly ? 1 : 0;
    living.stream()
        .filter(each -> !each.seen)
        .forEach(each -> lasted.add(seconds(each.since, scan.measured())));
    living.removeIf(each -> !each.seen);
    end = scan.measured();
  }

  private boolean isNear(float[] row, int beam) {
    return row[beam] < usual[beam] - NEARER && Float.isFinite(row[beam]);
  }

  private void note(Instant when, int from, int to) {
    for (Ghost each : living) {
      if (each.is(from, to)) {
        each.seen = true;
        each.from = from;
        each.to = to;
        return;
      }
    }
    living.add(new Ghost(when, from, to));
  }

  private static double seconds(Instant from, Instant to) {
    return Duration.between(from, to).toNanos() / 1e9;
  }

  @Override
  public long readings() {
    return scans;
  }

  @Override
  public List<NoiseParameter> parameters() {
    double time = scans > LEARNED ? seconds(begin, end) : Double.NaN;
    String basis = lasted.size() + " ghosts in " + Math.max(0, scans - LEARNED) + " scans";
    return List.of(
        new NoiseParameter("ghost_rate", lasted.size() / time, "1/s", basis),
        new NoiseParameter("ghost_duration", lasted.mean(), "s", basis),
        new NoiseParameter("ghostly", ghostly / (double) Math.max(1, scans - LEARNED), "", "scans"),
        new NoiseParameter(
            "white_noise_sigma", ranges.deviation(), "m", "the beam that meets the nearest thing"));
  }
}
