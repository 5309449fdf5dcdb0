package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * A receiver that tells by itself, in a fixed period: what the emulators of those have in common.
 * The first telling is at the first full period after it was switched on.
 */
abstract class StreamingDevice implements SerialDevice {

  /** With more than this waiting the line is too slow for what was asked; a moment is left out. */
  private static final int LONGEST_QUEUE = 4096;

  private final AntennaTrajectory path;
  private final Duration timeToFirstFix;
  private final UartLine channel;
  private final Schedule schedule = new Schedule();
  private @Nullable Instant powerOn;
  private boolean talks;

  /**
   * @param path where its antenna is
   * @param baud bits per second of its line
   * @param timeToFirstFix how long after it was switched on it looks for satellites
   * @param streaming whether it tells positions without being asked
   */
  StreamingDevice(AntennaTrajectory path, int baud, Duration timeToFirstFix, boolean streaming) {
    this.path = path;
    this.channel = new UartLine(baud);
    this.timeToFirstFix = timeToFirstFix;
    this.talks = streaming;
  }

  /** What it tells of a moment. */
  abstract void sendPosition(Instant time, boolean hasFix, AntennaState antenna);

  /** Takes the bytes of a command. */
  abstract void execute(byte[] bytes, int offset, int length, Instant time);

  /** Puts bytes on the line. */
  final void send(byte[] bytes, Instant time) {
    channel.send(bytes, time);
  }

  /** Tells from now on once in such a period. */
  final void setPeriod(Duration period, Instant now) {
    schedule.set(period, now);
  }

  /** Begins or ends to tell. */
  final void setStreaming(boolean streaming) {
    talks = streaming;
  }

  @Override
  public final int baud() {
    return channel.baud();
  }

  @Override
  public final void receive(byte[] bytes, int offset, int length, Instant time) {
    pass(time);
    execute(bytes, offset, length, time);
  }

  @Override
  public final void transmit(ByteBuffer out, Instant time) {
    pass(time);
    channel.drainTo(out, time);
  }

  private void pass(Instant time) {
    Instant on = powerOn;
    if (on == null) {
      on = time;
      powerOn = time;
      schedule.set(Duration.ofSeconds(1), time);
    }
    Instant due = schedule.due(time);
    if (due != null && talks && channel.waitingBytes() <= LONGEST_QUEUE) {
      boolean hasFix = !due.isBefore(on.plus(timeToFirstFix)) && path.hasSatellites(due);
      sendPosition(due, hasFix, path.at(due));
    }
  }
}
