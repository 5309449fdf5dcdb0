package org.dfra.cli.noise;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dfra.cli.noise.NoiseStudy.NoiseParameter;
import org.dfra.event.Reading;
import org.dfra.flow.sensor.AngularRate;
import org.jspecify.annotations.Nullable;

/**
 * Noise of the yaw rates of a stopped gyro. The white noise is the difference between consecutive
 * readings, since over an hour the drift exceeds the noise; the drift is the change of the means
 * over a second after a minute.
 */
final class GyroNoiseStudy implements NoiseStudy {

  private static final int MINUTE = 60; // means of a second

  private final IntervalMeans seconds = new IntervalMeans(Duration.ofSeconds(1));
  private final SampleSeries intervals = new SampleSeries(); // seconds
  private double last;
  private double squares; // of the differences between consecutive readings
  private long readings;
  private double firstMinute;
  private long inFirstMinute;
  private @Nullable Instant begin;
  private Instant before = Instant.MIN;

  @Override
  public void add(Reading reading) {
    if (!(reading instanceof AngularRate rate)) {
      return;
    }
    if (begin == null) {
      begin = rate.measured();
    } else {
      squares += (rate.rate() - last) * (rate.rate() - last);
      intervals.add(Duration.between(before, rate.measured()).toNanos() / 1e9);
    }
    if (Duration.between(begin, rate.measured()).toSeconds() < MINUTE) {
      firstMinute += rate.rate();
      inFirstMinute++;
    }
    last = rate.rate();
    before = rate.measured();
    readings++;
    seconds.add(rate.measured(), rate.rate());
  }

  @Override
  public long readings() {
    return readings;
  }

  @Override
  public List<NoiseParameter> parameters() {
    SampleSeries drifted = seconds.series().differences(MINUTE);
    return List.of(
        new NoiseParameter(
            "gyro_noise_density",
            Math.sqrt(squares / (readings - 1) / 2 * intervals.median()), // some may be lost
            "rad/s/√Hz",
            readings + " readings"),
        new NoiseParameter(
            "gyro_bias_sigma",
            Math.abs(firstMinute / inFirstMinute),
            "rad/s",
            "one draw; the root of the mean square of ten counts"),
        new NoiseParameter(
            "gyro_bias_random_walk",
            drifted.deviation() / Math.sqrt(MINUTE),
            "rad/s/√s",
            drifted.size() + " minutes, which overlap"));
  }
}
