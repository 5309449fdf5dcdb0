package org.dfra.cli.noise;

import java.time.Duration;
import java.util.List;
import org.dfra.cli.noise.NoiseStudy.NoiseParameter;
import org.dfra.event.Reading;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.geometry.LocalFrame;
import org.dfra.geometry.LocalPosition;
import org.jspecify.annotations.Nullable;

/**
 * Noise of the fixes of a stopped receiver. The white noise is the difference between consecutive
 * fixes; the slow noise is the difference between means over half minutes. East and north are
 * evaluated together.
 */
final class GpsNoiseStudy implements NoiseStudy {

  private static final Duration SPAN = Duration.ofSeconds(30);

  /** The correlation of a first-order Gauss-Markov process after its correlation time. */
  private static final double FALLEN = 1 / Math.E;

  private final SampleSeries east = new SampleSeries();
  private final SampleSeries north = new SampleSeries();
  private final IntervalMeans eastMeans = new IntervalMeans(SPAN);
  private final IntervalMeans northMeans = new IntervalMeans(SPAN);
  private @Nullable LocalFrame frame;

  @Override
  public void add(Reading reading) {
    if (!(reading instanceof GpsFix fix)) {
      return;
    }
    GeoPosition position = fix.position();
    if (position == null) {
      return;
    }
    if (frame == null) {
      frame = new LocalFrame(position);
    }
    LocalPosition at = frame.toLocal(position);
    east.add(at.east());
    north.add(at.north());
    eastMeans.add(fix.measured(), at.east());
    northMeans.add(fix.measured(), at.north());
  }

  @Override
  public long readings() {
    return east.size();
  }

  @Override
  public List<NoiseParameter> parameters() {
    String means = eastMeans.series().size() + " means of 30 s";
    return List.of(
        new NoiseParameter(
            "gps_white_noise_sigma",
            together(east.differences(1).deviation(), north.differences(1).deviation())
                / Math.sqrt(2),
            "m",
            east.size() + " fixes"),
        new NoiseParameter(
            "gps_bias_sigma",
            together(eastMeans.series().deviation(), northMeans.series().deviation()),
            "m",
            means),
        new NoiseParameter("gps_bias_correlation_time", correlationTime(), "s", means));
  }

  private static double together(double east, double north) {
    return Math.sqrt((east * east + north * north) / 2);
  }

  /** Seconds until the means' correlation has fallen to that value, linearly interpolated. */
  private double correlationTime() {
    double whole = covariance(0);
    double before = 1;
    for (int lag = 1; lag < eastMeans.series().size() / 2; lag++) {
      double now = covariance(lag) / whole;
      if (now <= FALLEN) {
        return SPAN.toSeconds() * (lag - 1 + (before - FALLEN) / (before - now));
      }
      before = now;
    }
    return Double.NaN;
  }

  private double covariance(int lag) {
    return eastMeans.series().covariance(lag) + northMeans.series().covariance(lag);
  }
}
