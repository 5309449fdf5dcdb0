package org.dfra.sim.device;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * What an M12+ does between its two wires: takes command bytes, sends message bytes. Knows no
 * thread and reads no clock; confined to one thread, which says what time it is.
 *
 * <p>Commands: {@code @@Ha} and {@code @@Ea} with a rate byte (0 once, n at once and every n
 * seconds), {@code @@Cj} (identification), {@code @@Aw} (1 tells UTC, 0 GPS time, FF asks),
 * {@code @@Cf} (defaults: sends nothing by itself any more). Everything else, and every damaged
 * command, is ignored. The settings outlive a client, as those of a receiver outlive the computer
 * on its line.
 */
public final class M12Device {

  /** With more than this waiting the line is too slow for what was asked; a message is left out. */
  private static final int LONGEST_QUEUE = 1024;

  private final AntennaPath path;
  private final Duration timeToFirstFix;
  private final UartLine line;
  private final M12CommandReader commands = new M12CommandReader(this::obey);

  private final Schedule position12 = new Schedule();
  private final Schedule position8 = new Schedule();
  private boolean tellsUtc = true;
  private @Nullable Instant powerOn;
  private Instant now = Instant.EPOCH;

  /**
   * @param path where its antenna is
   * @param baud bits per second of its line
   * @param timeToFirstFix how long after the first {@link #receive} or {@link #transmit} it looks
   *     for satellites before it has a position
   */
  public M12Device(AntennaPath path, int baud, Duration timeToFirstFix) {
    this.path = path;
    this.line = new UartLine(baud);
    this.timeToFirstFix = timeToFirstFix;
  }

  /** Takes bytes from the computer, cut anywhere. */
  public void receive(byte[] bytes, int offset, int length, Instant time) {
    pass(time);
    commands.feed(bytes, offset, length);
  }

  /**
   * Puts the bytes that have come out of the device by {@code time}, and not been put before, into
   * {@code out}, as far as they fit.
   */
  public void transmit(ByteBuffer out, Instant time) {
    pass(time);
    line.take(out, time);
  }

  private void pass(Instant time) {
    if (powerOn == null) {
      powerOn = time;
    }
    now = time;
    Instant due12 = position12.due(time);
    if (due12 != null) {
      send12(due12);
    }
    Instant due8 = position8.due(time);
    if (due8 != null) {
      send8(due8);
    }
  }

  private void obey(String id, int argument) {
    switch (id) {
      case "Ha" -> {
        position12.set(argument, now);
        send12(now);
      }
      case "Ea" -> {
        position8.set(argument, now);
        send8(now);
      }
      case "Cj" -> line.send(M12Frames.identification(), now);
      case "Aw" -> setTimeScale(argument);
      case "Cf" -> {
        position12.set(0, now);
        position8.set(0, now);
        tellsUtc = true;
        line.send(M12Frames.frame("Cf", new byte[0]), now);
      }
      default -> {
        // the receiver ignores what it does not know
      }
    }
  }

  private void setTimeScale(int argument) {
    if (argument <= 1 || argument == 0xFF) {
      tellsUtc = argument == 0xFF ? tellsUtc : argument == 1;
      line.send(M12Frames.frame("Aw", new byte[] {(byte) (tellsUtc ? 1 : 0)}), now);
    }
  }

  private void send12(Instant time) {
    if (line.waitingBytes() <= LONGEST_QUEUE) {
      line.send(M12Frames.position12(time, tellsUtc, hasFix(time), path.at(time)), time);
    }
  }

  private void send8(Instant time) {
    if (line.waitingBytes() <= LONGEST_QUEUE) {
      line.send(M12Frames.position8(time, tellsUtc, hasFix(time), path.at(time)), time);
    }
  }

  private boolean hasFix(Instant time) {
    return powerOn != null && !time.isBefore(powerOn.plus(timeToFirstFix));
  }

  /** When a message is sent again. */
  private static final class Schedule {

    private Duration period = Duration.ZERO;
    private Instant next = Instant.MAX;

    void set(int seconds, Instant now) {
      period = Duration.ofSeconds(seconds);
      next = seconds == 0 ? Instant.MAX : now.plus(period);
    }

    /** The last time due by now; null when there is none. Times slept through are left out. */
    @Nullable Instant due(Instant now) {
      if (period.isZero()) {
        return null;
      }
      if (now.plus(period).isBefore(next)) { // the clock was set back
        next = now.plus(period);
      }
      if (now.isBefore(next)) {
        return null;
      }
      long missed = Duration.between(next, now).dividedBy(period);
      Instant due = next.plus(period.multipliedBy(missed));
      next = due.plus(period);
      return due;
    }
  }
}
