package org.dfra.drivers.laser.lms;

import java.nio.charset.StandardCharsets;
import org.dfra.drivers.laser.lms.LmsParser.LmsCrc;
import org.dfra.drivers.laser.lms.LmsParser.LmsFramer;

/** Encodes the telegrams to the laser. */
public final class LmsCommands {

  private static final int LASER = 0x00;
  private static final String PASSWORD = "SICK_LMS";

  private LmsCommands() {}

  /** Resets it, like switching it off and on; {@code 91} answers, later {@code 90}. */
  public static byte[] reset() {
    return telegram(0x10);
  }

  /** Starts streaming at the highest rate that the link allows; {@code A0} answers. */
  public static byte[] stream() {
    return telegram(0x20, 0x24);
  }

  /** Stops streaming: scans are sent only on request; {@code A0} answers. */
  public static byte[] stop() {
    return telegram(0x20, 0x25);
  }

  /** Sets its baud rate; {@code A0} answers, still at the old rate. */
  public static byte[] baud(LmsBaud baud) {
    return telegram(0x20, baud.mode());
  }

  /**
   * Enters installation mode, which allows configuration, until another mode is set; {@code A0}
   * answers.
   */
  public static byte[] installation() {
    byte[] password = PASSWORD.getBytes(StandardCharsets.US_ASCII);
    int[] payload = new int[2 + password.length];
    payload[0] = 0x20;
    for (int i = 0; i < password.length; i++) {
      payload[2 + i] = password[i];
    }
    return telegram(payload);
  }

  /** Requests one scan; {@code B0} answers. */
  public static byte[] scan() {
    return telegram(0x30, 0x01);
  }

  /** Requests its status; {@code B1} answers. */
  public static byte[] status() {
    return telegram(0x31);
  }

  /** Requests its stored errors; {@code B2} answers. */
  public static byte[] errors() {
    return telegram(0x32);
  }

  /** Requests its type; {@code BA} answers. */
  public static byte[] type() {
    return telegram(0x3A);
  }

  /** Sets its field of view and resolution, until it is switched off; {@code BB} answers. */
  public static byte[] variant(LmsVariant variant) {
    return telegram(
        0x3B,
        variant.fieldDegrees() & 0xFF,
        variant.fieldDegrees() >> 8,
        variant.stepHundredths() & 0xFF,
        variant.stepHundredths() >> 8);
  }

  /** Requests its configuration; {@code F4} answers. */
  public static byte[] configuration() {
    return telegram(0x74);
  }

  /** Writes its configuration to its flash, in installation mode only; {@code F7} answers. */
  public static byte[] configure(LmsConfiguration configuration) {
    byte[] bytes = configuration.bytes();
    int[] payload = new int[1 + bytes.length];
    payload[0] = 0x77;
    for (int i = 0; i < bytes.length; i++) {
      payload[1 + i] = bytes[i];
    }
    return telegram(payload);
  }

  private static byte[] telegram(int... payload) {
    return telegram(LASER, payload);
  }

  /** A complete telegram, CRC included. */
  static byte[] telegram(int address, int[] payload) {
    int crcAt = LmsFramer.HEAD + payload.length;
    byte[] bytes = new byte[crcAt + LmsFramer.TAIL];
    bytes[0] = LmsFramer.STX;
    bytes[1] = (byte) address;
    bytes[2] = (byte) payload.length;
    bytes[3] = (byte) (payload.length >> 8);
    for (int i = 0; i < payload.length; i++) {
      bytes[LmsFramer.HEAD + i] = (byte) payload[i];
    }
    int crc = LmsCrc.of(bytes, 0, crcAt);
    bytes[crcAt] = (byte) crc;
    bytes[crcAt + 1] = (byte) (crc >> 8);
    return bytes;
  }
}
