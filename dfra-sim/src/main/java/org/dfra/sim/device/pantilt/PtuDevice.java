package org.dfra.sim.device.pantilt;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import org.dfra.sim.device.UartDevice;
import org.dfra.sim.device.pantilt.PtuConsole.PtuMotion;
import org.dfra.sim.physics.PanTiltPhysics;
import org.jspecify.annotations.Nullable;

/**
 * Emulates a pan-tilt unit, Directed Perception's type 46, at the byte level of its serial
 * interface: step motors that ramp up and down, limits, and ASCII commands that end with a space or
 * a carriage return.
 *
 * <p>At power-on it prints its identification and resets: it moves to both ends of both axes and to
 * 0, 0, which takes about 17 s. During the reset, and while it awaits the end of a motion ({@code
 * A}), it queues commands and answers them afterwards. It starts with echo on and verbose replies.
 * It loses its settings when it is switched off, not when its link is closed.
 *
 * <p>Commands, of each axis ({@code P} or {@code T}): {@code PP PO PD PS PA} to set and query,
 * {@code PR PN PX PB PU PL} to query. Of both: {@code H HP HT R RP RT I S A LE LD L ED EE E FT FV F
 * V}. It rejects others. In mode {@code S} the axes move to the set positions when {@code A}
 * arrives. With the limits off, an axis can run against its end stop and reports {@code !P} or
 * {@code !T}.
 *
 * <p>The emulator updates the head's direction at least every 10 ms during a motion. Source:
 * Directed Perception, PTU-D46 User's Manual 2.14.0, section 4; the end stops beyond the limits and
 * the wording of some rejections are assumed.
 */
public final class PtuDevice extends UartDevice {

  private static final double RADIANS_PER_POSITION = Math.toRadians(185.1428 / 3600);
  private static final int LONGEST_COMMAND = 40;
  private static final int LONGEST_INPUT = 1000; // characters of pending commands
  private static final int REPORT_EVERY = 10; // steps
  private static final Duration LONGEST_SLEEP = Duration.ofSeconds(60); // any motion has ended

  private final PanTiltPhysics body;
  private final StepperMotor pan = new StepperMotor('P', "Pan", -3090, 3090);
  private final StepperMotor tilt = new StepperMotor('T', "Tilt", -907, 604);
  private final PtuConsole console = new PtuConsole(pan, tilt, this::enqueue, this::begin);
  private final boolean resets;
  private final ArrayDeque<Character> input = new ArrayDeque<>();
  private final StringBuilder word = new StringBuilder();
  private @Nullable PtuMotion motion; // motion that must end before the next command
  private @Nullable Instant now; // null: not switched on
  private double reportedPan = Double.NaN;
  private double reportedTilt = Double.NaN;

  /**
   * @param body the head
   * @param baud bits per second of its serial line, 9600 ex factory
   * @param resets whether it resets at power-on
   */
  public PtuDevice(PanTiltPhysics body, int baud, boolean resets) {
    super(baud);
    this.body = body;
    this.resets = resets;
  }

  @Override
  public void receive(byte[] bytes, int offset, int length, Instant time) {
    advance(time);
    for (int i = offset; i < offset + length && input.size() < LONGEST_INPUT; i++) {
      input.add((char) (bytes[i] & 0xFF));
    }
    read();
  }

  @Override
  protected void advance(Instant time) {
    Instant last = now;
    if (last == null) {
      now = time;
      switchOn(time);
      return;
    }
    Duration slept = Duration.between(last, time);
    if (slept.isNegative() || slept.compareTo(LONGEST_SLEEP) > 0) { // the clock was set
      last = time.minus(slept.isNegative() ? Duration.ZERO : LONGEST_SLEEP);
    }
    long steps = Duration.between(last, time).toMillis();
    for (long i = 1; i <= steps; i++) {
      Instant at = last.plusMillis(i);
      now = at;
      step(at, i % REPORT_EVERY == 0 || i == steps);
    }
    if (steps == 0) {
      now = last;
    }
  }

  private void switchOn(Instant time) {
    enqueue("\r\n### PAN-TILT CONTROLLER\r\n### EMULATOR\r\n");
    moveHead(time);
    if (resets) {
      enqueue("Initializing...\r\n");
      begin(PtuMotion.reset(pan, tilt));
    } else {
      enqueue("*\r\n");
    }
  }

  private void step(Instant at, boolean reports) {
    boolean arrives = false;
    for (StepperMotor motor : new StepperMotor[] {pan, tilt}) {
      boolean moved = motor.isMoving();
      motor.step();
      arrives |= moved && !motor.isMoving();
      if (motor.pollLimitHit()) {
        enqueue("!" + motor.letter() + "\r\n");
      }
    }
    if (reports || arrives) {
      moveHead(at);
    }
    PtuMotion going = motion;
    if (going != null && going.isOver()) {
      motion = null;
      enqueue(console.done());
      read();
    }
  }

  private void moveHead(Instant at) {
    double atPan = pan.exactPosition() * RADIANS_PER_POSITION;
    double atTilt = tilt.exactPosition() * RADIANS_PER_POSITION;
    if (atPan != reportedPan || atTilt != reportedTilt) {
      reportedPan = atPan;
      reportedTilt = atTilt;
      body.point(at, atPan, atTilt);
    }
  }

  /** Executes received commands, up to one that must wait for a motion. */
  private void read() {
    while (motion == null && !input.isEmpty()) {
      char next = input.remove();
      if (console.echoes()) {
        enqueue(String.valueOf(next));
      }
      if (next != ' ' && next != '\r') {
        if (word.length() < LONGEST_COMMAND && next > ' ') {
          word.append(next);
        }
      } else if (word.length() > 0) {
        String command = word.toString();
        word.setLength(0);
        console.execute(command);
      }
    }
  }

  private void begin(PtuMotion next) {
    motion = next;
  }

  private void enqueue(String text) {
    Instant time = now;
    if (time != null && !text.isEmpty()) {
      channel().send(text.getBytes(StandardCharsets.ISO_8859_1), time);
    }
  }
}
