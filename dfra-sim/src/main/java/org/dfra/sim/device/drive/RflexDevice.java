package org.dfra.sim.device.drive;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.time.Instant;
import org.dfra.sim.device.Schedule;
import org.dfra.sim.device.UartDevice;
import org.dfra.sim.physics.BatteryPhysics;
import org.dfra.sim.physics.DrivetrainPhysics;
import org.dfra.sim.physics.DrivetrainPhysics.Travel;
import org.jspecify.annotations.Nullable;

/**
 * Emulates an rFLEX controller between its serial interface, its motors and its battery.
 *
 * <p>Commands: set velocity (2/7), report request (2/34), defaults (2/10), set and release brake
 * (2/11, 2/12), status (1/1). Unknown and damaged commands are ignored, and so is a velocity while
 * the brake is set.
 *
 * <p>At power-on, that is at its first use, its brake is set, its counts are 0 and it reports
 * nothing. Its failsafe follows the reported one of the real controller: when no velocity command
 * arrives for {@link #FAILSAFE}, it brakes the wheels by {@value #STOPPING} m/s², so that they stop
 * within half a second of the last velocity from 1 m/s. To switch it off and on, replace it by a
 * new one with the same wheels.
 */
public final class RflexDevice extends UartDevice {

  /** Bits per second of its serial line. */
  public static final int BAUD = 115_200;

  /** Counts per metre. */
  public static final double PER_METRE = 87_462.73;

  /** Counts per radian. */
  public static final double PER_RADIAN = 36_277.67;

  /** Timeout of velocity commands. */
  public static final Duration FAILSAFE = Duration.ofMillis(300);

  /** Deceleration of the failsafe, metres per second squared. */
  public static final double STOPPING = 6;

  /** The same about z, radians per second squared; from 2 rad/s it takes as long. */
  private static final double FAILSAFE_YAW_DECELERATION = 12;

  private static final double USUAL_ACCELERATION = 0.5;
  private static final double OFFSET_VOLTS = 1.2;

  /**
   * If more bytes than this are queued, the baud rate is too low for the requested reports; a
   * report is skipped.
   */
  private static final int LONGEST_QUEUE = 1024;

  /** One axis as commanded. */
  private static final class Axis {
    final double perUnit;
    final int first;
    double speed;
    double acceleration = USUAL_ACCELERATION;
    double begin; // of the wheels, when it was switched on

    Axis(double perUnit, int first) {
      this.perUnit = perUnit;
      this.first = first;
    }

    int count(double travelled) {
      return first + (int) Math.round((travelled - begin) * perUnit); // wraps around
    }

    int rate(double speedNow) {
      return (int) Math.round(speedNow * perUnit);
    }

    void stop(double by) {
      speed = 0;
      acceleration = by;
    }
  }

  private final DrivetrainPhysics wheels;
  private final BatteryPhysics battery;
  private final RflexCommandReader commands = new RflexCommandReader(this::execute);
  private final Schedule reports = new Schedule();
  private final Axis along;
  private final Axis about;
  private boolean brake = true;
  private @Nullable Instant powerOn;
  private Instant now = Instant.EPOCH;
  private @Nullable Instant failsafe; // when it is due
  private boolean isHalfMotion; // the other axis' half is pending
  private volatile @Nullable Instant lastMotion;
  private volatile @Nullable Instant firstHalt;

  /** A controller of these wheels, powered by this battery. */
  public RflexDevice(DrivetrainPhysics wheels, BatteryPhysics battery) {
    this(wheels, battery, 0, 0);
  }

  /**
   * A controller with other initial counts, such as near the overflow of 32 bits.
   *
   * @param first its first count along x
   * @param firstTurn its first count about z
   */
  public RflexDevice(DrivetrainPhysics wheels, BatteryPhysics battery, int first, int firstTurn) {
    super(BAUD);
    this.wheels = wheels;
    this.battery = battery;
    this.along = new Axis(PER_METRE, first);
    this.about = new Axis(PER_RADIAN, firstTurn);
  }

  /** Frames that it could not parse. */
  public long malformedFrames() {
    return commands.malformedFrames();
  }

  /**
   * Time of the last motion command: a velocity of more than 1 count per second, or the velocity
   * about z sent together with it. Null before the first. Any thread may call it.
   */
  public @Nullable Instant lastMotion() {
    return lastMotion;
  }

  /**
   * Time of the first stop command after the {@linkplain #lastMotion last motion}: a zero velocity,
   * an invalid one, or the brake. Null before the first; the controller's own failsafe does not
   * count. Any thread may call it.
   */
  public @Nullable Instant firstHalt() {
    return firstHalt;
  }

  private void halted() {
    firstHalt = firstHalt == null ? now : firstHalt;
  }

  @Override
  public void receive(byte[] bytes, int offset, int length, Instant time) {
    advance(time);
    commands.feed(bytes, offset, length);
  }

  @Override
  protected void advance(Instant time) {
    if (powerOn == null) {
      powerOn = time;
      wheels.brake(time, true);
      Travel begin = wheels.travel(time);
      along.begin = begin.distance();
      about.begin = begin.yaw();
    }
    if (failsafe != null && !time.isBefore(failsafe)) {
      now = failsafe; // at that time, even if it was not polled then
      stop();
    }
    now = time;
    Instant due = reports.due(time);
    if (due != null && channel().waitingBytes() <= LONGEST_QUEUE) {
      report(due);
    }
  }

  private void stop() {
    failsafe = null;
    along.stop(STOPPING);
    about.stop(FAILSAFE_YAW_DECELERATION);
    drive();
  }

  private void drive() {
    wheels.drive(now, along.speed, about.speed, along.acceleration, about.acceleration);
  }

  private void execute(int port, int opcode, byte[] data) {
    ByteBuffer argument = ByteBuffer.wrap(data);
    switch (port << 8 | opcode) {
      case 0x0101 -> status();
      case 0x0207 -> setVelocity(argument);
      case 0x020A -> {
        halted();
        stop();
      }
      case 0x020B -> {
        halted();
        setBrake(true);
      }
      case 0x020C -> setBrake(false);
      case 0x0222 -> requestReports(argument);
      default -> {
        // it ignores unknown commands
      }
    }
  }

  private void setVelocity(ByteBuffer argument) {
    if (argument.remaining() != 14) {
      return;
    }
    Axis axis = argument.get() == 0 ? along : about;
    long counts = Integer.toUnsignedLong(argument.getInt());
    double speed = counts / axis.perUnit;
    double acceleration = Integer.toUnsignedLong(argument.getInt()) / axis.perUnit;
    int unusedTorque = argument.getInt();
    boolean isPositive = argument.get() == 1;
    if (brake) {
      return;
    }
    axis.speed = isPositive ? speed : -speed;
    axis.acceleration = acceleration > 0 ? acceleration : USUAL_ACCELERATION;
    failsafe = now.plus(FAILSAFE);
    if (counts > 1 || (isHalfMotion && axis == about)) {
      lastMotion = now;
      firstHalt = null;
    } else {
      halted();
    }
    isHalfMotion = counts > 1 && axis == along;
    drive();
  }

  private void setBrake(boolean set) {
    brake = set;
    if (set) {
      stop();
    }
    wheels.brake(now, set);
  }

  private void requestReports(ByteBuffer argument) {
    if (argument.remaining() == 8) {
      long micros = Integer.toUnsignedLong(argument.getInt());
      reports.set(Duration.ofNanos(micros * 1000), now);
    }
  }

  private void status() {
    int hundredths = (int) Math.round((battery.at(now).voltage() - OFFSET_VOLTS) * 100);
    channel().send(RflexFrames.status(timestamp(now), Math.max(0, hundredths), brake), now);
  }

  private void report(Instant due) {
    Travel travel = wheels.travel(due);
    int time = timestamp(due);
    byte[] first =
        RflexFrames.report(
            time,
            0,
            along.count(travel.distance()),
            along.rate(travel.speed()),
            along.rate(along.acceleration));
    byte[] second =
        RflexFrames.report(
            time,
            1,
            about.count(travel.yaw()),
            about.rate(travel.yawRate()),
            about.rate(about.acceleration));
    channel().send(first, due);
    channel().send(second, due);
  }

  /** Microseconds since power-on; wraps around. */
  private int timestamp(Instant time) {
    return (int) (Duration.between(powerOn == null ? time : powerOn, time).toNanos() / 1000);
  }

  /** Encodes the frames of an rFLEX controller. Its numbers may contain 1B unescaped. */
  private static final class RflexFrames {

    private static final int AROUND = 9;

    private RflexFrames() {}

    /** Port 2, opcode 33: position and velocity of an axis. */
    static byte[] report(int timestamp, int axis, int position, int velocity, int acceleration) {
      ByteBuffer data = ByteBuffer.allocate(25);
      data.putInt(0).putInt(timestamp).put((byte) axis).putInt(position).putInt(velocity);
      return frame(2, 33, data.putInt(acceleration).putInt(30_000).array());
    }

    /** Port 1, opcode 1: hundredths of a volt, and the brake. */
    static byte[] status(int timestamp, int hundredths, boolean brake) {
      ByteBuffer data = ByteBuffer.allocate(9).putInt(timestamp).putInt(hundredths);
      return frame(1, 1, data.put((byte) (brake ? 1 : 0)).array());
    }

    private static byte[] frame(int port, int opcode, byte[] data) {
      ByteBuffer frame = ByteBuffer.allocate(data.length + AROUND);
      frame.put((byte) 0x1B).put((byte) 0x02);
      frame.put((byte) port).put((byte) 0).put((byte) opcode).put((byte) data.length).put(data);
      byte sum = 0;
      for (int i = 2; i < frame.position(); i++) {
        sum ^= frame.get(i);
      }
      return frame.put(sum).put((byte) 0x1B).put((byte) 0x03).array();
    }
  }
}
