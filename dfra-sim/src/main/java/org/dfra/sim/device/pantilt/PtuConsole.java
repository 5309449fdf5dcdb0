package org.dfra.sim.device.pantilt;

import java.util.ArrayDeque;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** Executes commands, each without its delimiter. */
final class PtuConsole {

  private static final Pattern COMMAND = Pattern.compile("([A-Z]{1,2})([-+]?[0-9]{1,6})?");
  private static final String END = "\r\n";

  private final StepperMotor pan;
  private final StepperMotor tilt;
  private final Consumer<String> printer;
  private final Consumer<PtuMotion> motions;
  private boolean echo = true;
  private boolean terse;
  private boolean limited = true;
  private boolean immediate = true;
  private @Nullable Integer awaitedPan;
  private @Nullable Integer awaitedTilt;

  /**
   * @param printer receives its output
   * @param motions receives a motion that must end before the next command; {@link #done} is the
   *     reply then
   */
  PtuConsole(
      StepperMotor pan, StepperMotor tilt, Consumer<String> printer, Consumer<PtuMotion> motions) {
    this.pan = pan;
    this.tilt = tilt;
    this.printer = printer;
    this.motions = motions;
  }

  boolean echoes() {
    return echo;
  }

  /** The reply to a command that was executed. */
  String done() {
    return "*" + END;
  }

  void execute(String command) {
    Matcher matcher = COMMAND.matcher(command.toUpperCase(Locale.ROOT));
    if (!matcher.matches()) {
      refuse("Illegal command");
      return;
    }
    String name = matcher.group(1);
    String number = matcher.group(2);
    boolean isOfAxis = name.length() == 2 && (name.charAt(0) == 'P' || name.charAt(0) == 'T');
    if (isOfAxis) {
      StepperMotor motor = name.charAt(0) == 'P' ? pan : tilt;
      if (number == null) {
        answer(motor, name.charAt(1));
      } else {
        set(motor, name.charAt(1), Integer.parseInt(number));
      }
    } else if (number != null) {
      refuse("Illegal command argument");
    } else {
      executeForBothAxes(name);
    }
  }

  private void answer(StepperMotor motor, char what) {
    String name = motor.name();
    switch (what) {
      case 'P' -> replyNumber("Current " + name + " position is ", motor.position(), "");
      case 'O', 'D' -> replyNumber("Desired " + name + " position is ", motor.target(), "");
      case 'S' -> replyNumber("Target " + name + " speed is ", motor.speed(), " positions/sec");
      case 'A' -> replyNumber(name + " acceleration is ", motor.acceleration(), " positions/sec^2");
      case 'B' ->
          replyNumber("Current " + name + " base speed is ", motor.baseSpeed(), " positions/sec");
      case 'U' -> replyNumber("Maximum " + name + " speed is ", motor.maxSpeed(), " positions/sec");
      case 'L' -> replyNumber("Minimum " + name + " speed is ", motor.minSpeed(), " positions/sec");
      case 'N' -> replyNumber("Minimum " + name + " position is ", motor.minPosition(), "");
      case 'X' -> replyNumber("Maximum " + name + " position is ", motor.maxPosition(), "");
      case 'R' -> reply("185.1428" + (terse ? "" : " seconds arc per " + name + " position"));
      default -> refuse("Illegal command");
    }
  }

  private void set(StepperMotor motor, char what, int number) {
    switch (what) {
      case 'P' -> position(motor, number);
      case 'O' -> position(motor, motor.position() + number);
      case 'S' -> speed(motor, number);
      case 'A' -> {
        if (number < 1) {
          refuse("Acceleration must be positive");
        } else {
          motor.setAcceleration(number);
          printer.accept(done());
        }
      }
      default -> refuse("Illegal command argument");
    }
  }

  private void position(StepperMotor motor, int there) {
    if (!motor.isReachable(there)) {
      boolean over = there > motor.maxPosition();
      refuse(
          (over ? "Maximum" : "Minimum")
              + " allowable "
              + motor.name()
              + " position is "
              + (over ? motor.maxPosition() : motor.minPosition()));
      return;
    }
    if (immediate) {
      motor.goTo(there);
    } else if (motor == pan) {
      awaitedPan = there;
    } else {
      awaitedTilt = there;
    }
    printer.accept(done());
  }

  private void speed(StepperMotor motor, int speed) {
    if (speed > motor.maxSpeed()) {
      refuse(motor.name() + " speed cannot exceed " + motor.maxSpeed() + " positions/sec");
    } else if (speed < motor.minSpeed()) {
      refuse("Motor speed cannot be less than " + motor.minSpeed() + " pos/sec");
    } else {
      motor.setSpeed(speed);
      printer.accept(done());
    }
  }

  private void executeForBothAxes(String name) {
    switch (name) {
      case "E" -> reply("Echoing is " + (echo ? "ON" : "OFF"));
      case "F" -> reply("ASCII " + (terse ? "terse" : "verbose") + " mode");
      case "L" -> reply("Limit bounds are " + (limited ? "ENABLED" : "DISABLED"));
      case "V" -> reply("Pan-Tilt Controller v1.10 (EMULATOR)");
      case "R" -> motions.accept(PtuMotion.reset(pan, tilt));
      case "RP" -> motions.accept(PtuMotion.reset(pan));
      case "RT" -> motions.accept(PtuMotion.reset(tilt));
      case "A" -> {
        moveToDeferredTargets();
        motions.accept(PtuMotion.ending(pan, tilt));
      }
      default -> {
        if (isSet(name)) {
          printer.accept(done());
        } else {
          refuse("Illegal command");
        }
      }
    }
  }

  /** Executes a setting command without a reply value; false when there is no such command. */
  private boolean isSet(String name) {
    switch (name) {
      case "EE", "ED" -> echo = name.equals("EE");
      case "FT", "FV" -> terse = name.equals("FT");
      case "LE", "LD" -> limit(name.equals("LE"));
      case "I", "S" -> immediate = name.equals("I");
      case "H" -> {
        pan.halt();
        tilt.halt();
      }
      case "HP" -> pan.halt();
      case "HT" -> tilt.halt();
      default -> {
        return false;
      }
    }
    return true;
  }

  private void limit(boolean whether) {
    limited = whether;
    pan.limit(whether);
    tilt.limit(whether);
  }

  private void moveToDeferredTargets() {
    if (awaitedPan != null) {
      pan.goTo(awaitedPan);
    }
    if (awaitedTilt != null) {
      tilt.goTo(awaitedTilt);
    }
    awaitedPan = null;
    awaitedTilt = null;
  }

  private void replyNumber(String before, int number, String after) {
    reply(terse ? Integer.toString(number) : before + number + after);
  }

  private void reply(String text) {
    printer.accept("* " + text + END);
  }

  private void refuse(String why) {
    printer.accept("! " + why + END);
  }

  /** A motion that the unit completes before it executes the next command. */
  static final class PtuMotion {

    private final StepperMotor pan;
    private final StepperMotor tilt;
    private final ArrayDeque<Runnable> legs = new ArrayDeque<>();

    private PtuMotion(StepperMotor pan, StepperMotor tilt) {
      this.pan = pan;
      this.tilt = tilt;
    }

    /** Until both axes reach their commanded positions. */
    static PtuMotion ending(StepperMotor pan, StepperMotor tilt) {
      return new PtuMotion(pan, tilt);
    }

    /** Each given axis to its one limit, to the other, and to 0; one axis after the other. */
    static PtuMotion reset(StepperMotor... motors) {
      PtuMotion motion = new PtuMotion(motors[0], motors[motors.length - 1]);
      for (StepperMotor motor : motors) {
        motion.legs.add(() -> motor.goTo(motor.minPosition()));
        motion.legs.add(() -> motor.goTo(motor.maxPosition()));
        motion.legs.add(() -> motor.goTo(0));
      }
      return motion;
    }

    /** Starts the next leg when one has ended; returns whether all have ended. */
    boolean isOver() {
      if (pan.isMoving() || tilt.isMoving()) {
        return false;
      }
      Runnable next = legs.poll();
      if (next == null) {
        return true;
      }
      next.run();
      return false;
    }
  }
}
