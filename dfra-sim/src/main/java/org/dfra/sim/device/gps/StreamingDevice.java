package org.dfra.sim.device.gps;

import java.time.Duration;
import java.time.Instant;
import org.dfra.sim.device.Schedule;
import org.dfra.sim.device.UartDevice;
import org.dfra.sim.device.gps.AntennaTrajectory.AntennaState;
import org.jspecify.annotations.Nullable;

/**
 * Base of emulated receivers that send periodic, unsolicited reports. The first report is due at
 * the first full period after power-on.
 */
abstract class StreamingDevice extends UartDevice {

  /** If more bytes than this are queued, the baud rate is too low; a report is skipped. */
  private static final int LONGEST_QUEUE = 4096;

  private final AntennaTrajectory path;
  private final Duration timeToFirstFix;
  private final Schedule schedule = new Schedule();
  private @Nullable Instant powerOn;
  private boolean talks;

  /**
   * @param path trajectory of its antenna
   * @param baud bits per second of its serial line
   * @param timeToFirstFix time from power-on to the first fix
   * @param streaming whether it sends positions unsolicited
   */
  StreamingDevice(AntennaTrajectory path, int baud, Duration timeToFirstFix, boolean streaming) {
    super(baud);
    this.path = path;
    this.timeToFirstFix = timeToFirstFix;
    this.talks = streaming;
  }

  /** Sends the report of one time. */
  abstract void sendPosition(Instant time, boolean hasFix, AntennaState antenna);

  /** Receives the bytes of a command. */
  abstract void execute(byte[] bytes, int offset, int length, Instant time);

  /** Sends bytes. */
  final void send(byte[] bytes, Instant time) {
    channel().send(bytes, time);
  }

  /** Sets the period of reports. */
  final void setPeriod(Duration period, Instant now) {
    schedule.set(period, now);
  }

  /** Starts or stops reports. */
  final void setStreaming(boolean streaming) {
    talks = streaming;
  }

  @Override
  public final void receive(byte[] bytes, int offset, int length, Instant time) {
    advance(time);
    execute(bytes, offset, length, time);
  }

  @Override
  protected void advance(Instant time) {
    Instant on = powerOn;
    if (on == null) {
      on = time;
      powerOn = time;
      schedule.set(Duration.ofSeconds(1), time);
    }
    Instant due = schedule.due(time);
    if (due != null && talks && channel().waitingBytes() <= LONGEST_QUEUE) {
      boolean hasFix = !due.isBefore(on.plus(timeToFirstFix)) && path.hasSatellites(due);
      sendPosition(due, hasFix, path.at(due));
    }
  }
}
