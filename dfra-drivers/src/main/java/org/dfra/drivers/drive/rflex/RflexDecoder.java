package org.dfra.drivers.drive.rflex;

import java.util.ArrayList;
import java.util.List;
import org.dfra.drivers.drive.rflex.RflexMessage.Axis;
import org.dfra.drivers.drive.rflex.RflexMessage.Echo;
import org.dfra.drivers.drive.rflex.RflexMessage.Malformed;
import org.dfra.drivers.drive.rflex.RflexMessage.MotorReport;
import org.dfra.drivers.drive.rflex.RflexMessage.Other;
import org.dfra.drivers.drive.rflex.RflexMessage.SonarReport;
import org.dfra.drivers.drive.rflex.RflexMessage.SystemStatus;
import org.dfra.drivers.drive.rflex.RflexParser.RflexFramer;

/** Decodes intact frames into messages. Pure; never throws, whatever the frame. */
final class RflexDecoder {

  static final int SYSTEM = 1;
  static final int MOTION = 2;
  static final int SONAR = 4;

  static final int STATUS = 1;
  static final int MOTOR_REPORT = 33;
  static final int SONAR_REPORT = 2;

  private static final int LAST_PORT = 6;
  private static final int STATUS_LENGTH = 9;
  private static final int MOTOR_LENGTH = 25;
  private static final int SONAR_HEAD = 8;
  private static final int ECHO_LENGTH = 3;

  /**
   * Maximum plausible battery voltage; a higher value is a transmission error that the checksum
   * missed.
   */
  private static final double MOST_VOLTS = 60;

  private static final double SONAR_UNITS_PER_METRE = 1476;

  private RflexDecoder() {}

  /** Whether the controller sends such frames with data of this length. */
  static boolean isKnownLength(int port, int opcode, int length) {
    if (port < SYSTEM || port > LAST_PORT) {
      return false;
    }
    return switch (port << 8 | opcode) {
      case SYSTEM << 8 | STATUS -> length == STATUS_LENGTH;
      case MOTION << 8 | MOTOR_REPORT -> length == MOTOR_LENGTH;
      case SONAR << 8 | SONAR_REPORT ->
          length >= SONAR_HEAD && (length - SONAR_HEAD) % ECHO_LENGTH == 0;
      default -> true;
    };
  }

  /**
   * Decodes one frame.
   *
   * @param bytes holds it
   * @param offset index of its first byte
   * @param length its length in bytes
   */
  public static RflexMessage decode(byte[] bytes, int offset, int length) {
    int port = bytes[offset + 2] & 0xFF;
    int opcode = bytes[offset + 4] & 0xFF;
    return switch (port << 8 | opcode) {
      case SYSTEM << 8 | STATUS -> status(bytes, offset);
      case MOTION << 8 | MOTOR_REPORT -> motor(bytes, offset);
      case SONAR << 8 | SONAR_REPORT -> sonar(bytes, offset, length);
      default -> new Other(port, opcode, length - RflexFramer.AROUND);
    };
  }

  private static RflexMessage status(byte[] bytes, int offset) {
    double volts = Integer.toUnsignedLong(whole(bytes, offset + 10)) / 100.0;
    return volts > MOST_VOLTS
        ? new Malformed(
            SYSTEM, STATUS, "a voltage of " + volts + " V, more than " + MOST_VOLTS + " V")
        : new SystemStatus(timestamp(bytes, offset + 6), volts, bytes[offset + 14] != 0);
  }

  private static RflexMessage motor(byte[] bytes, int offset) {
    int axis = bytes[offset + 14] & 0xFF;
    return axis >= Axis.values().length
        ? new Malformed(MOTION, MOTOR_REPORT, "axis " + axis + ", but there are 0 and 1")
        : new MotorReport(
            timestamp(bytes, offset + 10),
            Axis.values()[axis],
            whole(bytes, offset + 15),
            whole(bytes, offset + 19),
            whole(bytes, offset + 23),
            whole(bytes, offset + 27));
  }

  private static RflexMessage sonar(byte[] bytes, int offset, int length) {
    List<Echo> echoes = new ArrayList<>();
    int end = offset + length - 3;
    for (int at = offset + 14; at + ECHO_LENGTH <= end; at += ECHO_LENGTH) {
      int range = (bytes[at + 1] & 0xFF) << 8 | (bytes[at + 2] & 0xFF);
      echoes.add(new Echo(bytes[at] & 0xFF, range / SONAR_UNITS_PER_METRE));
    }
    return new SonarReport(timestamp(bytes, offset + 10), echoes);
  }

  private static long timestamp(byte[] bytes, int at) {
    return Integer.toUnsignedLong(whole(bytes, at));
  }

  private static int whole(byte[] bytes, int at) {
    return (bytes[at] & 0xFF) << 24
        | (bytes[at + 1] & 0xFF) << 16
        | (bytes[at + 2] & 0xFF) << 8
        | (bytes[at + 3] & 0xFF);
  }
}
