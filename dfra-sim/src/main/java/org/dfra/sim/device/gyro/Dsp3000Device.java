package org.dfra.sim.device.gyro;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import org.dfra.sim.device.UartDevice;
import org.dfra.sim.physics.GyroInput;
import org.jspecify.annotations.Nullable;

/**
 * Emulates a fibre-optic rate gyro, KVH's DSP-3000, at the byte level of its serial interface: a
 * text line with a number and its validity, a hundred times a second, clockwise +.
 *
 * <p>Commands, single letters: {@code R} rate in degrees per second, {@code A} the angle since the
 * previous line, {@code P} the angle since {@code Z}, both in degrees. It starts in rate mode and
 * keeps its mode while it is on. Its lines are invalid during warm-up and above its maximum rate.
 * These two rules, and that commands need no end of line, are assumed or taken from other drivers.
 */
public final class Dsp3000Device extends UartDevice {

  private static final Duration PERIOD = Duration.ofMillis(10);
  private static final double FASTEST = 375; // °/s
  private static final int PLACES = 6; // of its numbers
  private static final long MILLION = 1_000_000;
  private static final int LONGEST_QUEUE = 1024; // bytes; above this a line is skipped
  private static final Duration LONGEST_SLEEP =
      Duration.ofSeconds(10); // missed lines are sent for this

  private final GyroInput view;
  private final Duration warmUp;
  private @Nullable Instant switchedOn;
  private Instant next = Instant.MIN;
  private char mode = 'R';
  private double angle; // degrees since Z, clockwise is +

  /**
   * @param view input of its sensor
   * @param baud bits per second of its serial line, 38400 ex factory
   * @param warmUp how long its lines are invalid after power-on
   */
  public Dsp3000Device(GyroInput view, int baud, Duration warmUp) {
    super(baud);
    this.view = view;
    this.warmUp = warmUp;
  }

  @Override
  public void receive(byte[] bytes, int offset, int length, Instant time) {
    advance(time);
    for (int i = offset; i < offset + length; i++) {
      char envelope = (char) (bytes[i] & 0xFF);
      if (envelope == 'R' || envelope == 'A' || envelope == 'P') {
        mode = envelope;
      } else if (envelope == 'Z') {
        angle = 0;
      }
    }
  }

  @Override
  protected void advance(Instant time) {
    if (switchedOn == null) {
      switchedOn = time;
      next = time.plus(PERIOD);
    }
    Duration late = Duration.between(next, time);
    if (late.compareTo(LONGEST_SLEEP) > 0 || late.plus(PERIOD).isNegative()) { // the clock was set
      next = time;
    }
    for (; !next.isAfter(time); next = next.plus(PERIOD)) {
      measure(next, switchedOn);
    }
  }

  private void measure(Instant time, Instant begin) {
    double rate = -Math.toDegrees(view.rate(time));
    double reported = Math.max(-FASTEST, Math.min(FASTEST, rate));
    double step = reported * PERIOD.toMillis() / 1e3;
    angle += step;
    boolean isValid = reported == rate && !time.isBefore(begin.plus(warmUp));
    double number = mode == 'R' ? reported : mode == 'A' ? step : angle;
    if (channel().waitingBytes() <= LONGEST_QUEUE) {
      channel().send(text(number, isValid).getBytes(StandardCharsets.US_ASCII), time);
    }
  }

  /**
   * Six decimal places; formatted by hand, since a formatter took half of the CPU time of a
   * stationary robot.
   */
  private static String text(double number, boolean isValid) {
    long size = Math.round(Math.abs(number) * MILLION);
    StringBuilder text = new StringBuilder();
    text.append(Double.compare(number, 0) < 0 ? "-" : ""); // zero may be signed, too
    text.append(size / MILLION).append('.');
    text.append(MILLION + size % MILLION).deleteCharAt(text.length() - PLACES - 1);
    return text.append(isValid ? " 1\r\n" : " 0\r\n").toString();
  }
}
