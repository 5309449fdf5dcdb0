package org.dfra.drivers.laser.lms;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dfra.drivers.laser.lms.LmsConfiguration.LmsUnit;
import org.dfra.drivers.laser.lms.LmsMessage.LmsError;
import org.dfra.drivers.laser.lms.LmsParser.LmsFramer;

/**
 * Decodes intact frames, one at a time. Pure; never throws, whatever the content of a frame: an
 * invalid value makes a {@link LmsMessage.Malformed}.
 */
final class LmsDecoder {

  /** Bytes of a status reply up to the last of interest. */
  private static final int STATUS_BYTES = 124;

  private static final int POLLUTION_CHANNELS = 8;

  private LmsDecoder() {}

  /**
   * Decodes a frame found by {@link LmsFramer}.
   *
   * @param bytes holds it
   * @param offset index of its first byte
   * @param length its length in bytes
   */
  public static LmsMessage decode(byte[] bytes, int offset, int length) {
    if (length == 1) {
      return new LmsMessage.Nak();
    }
    int at = offset + (bytes[offset] == LmsFramer.ACK ? 1 : 0) + LmsFramer.HEAD;
    int end = offset + length - LmsFramer.TAIL - 1;
    StatusByte status = new StatusByte(bytes[end] & 0xFF);
    int command = bytes[at] & 0xFF;
    return switch (command) {
      case 0xB0 -> scan(bytes, at, end, status);
      case 0x90, 0xBA ->
          new LmsMessage.TypeReply(command == 0x90, text(bytes, at + 1, end - at - 1), status);
      case 0x91 -> new LmsMessage.ResetReply(status);
      case 0x92 -> new LmsMessage.RefusedReply(status);
      case 0xA0 ->
          end - at < 2
              ? malformed(command, "it has no result")
              : new LmsMessage.ModeReply(bytes[at + 1] & 0xFF, status);
      case 0xB1 -> status(bytes, at, end, status);
      case 0xB2 -> errors(bytes, at + 1, end, status);
      case 0xBB -> variant(bytes, at, end, status);
      case 0xF4, 0xF7 -> configuration(bytes, at, end, status);
      default -> new LmsMessage.Other(command, status);
    };
  }

  private static LmsMessage scan(byte[] bytes, int at, int end, StatusByte status) {
    int data = end - at - 3;
    if (data < 0) {
      return malformed(0xB0, "it has no count of samples");
    }
    int high = bytes[at + 2] & 0xFF;
    int count = bytes[at + 1] & 0xFF | (high & 3) << 8;
    int counters = data - 2 * count;
    if (counters < 0 || counters > 2) {
      return malformed(0xB0, count + " samples do not fit " + data + " bytes");
    }
    if (count == 0 || high >> 6 == LmsUnit.values().length) {
      return malformed(0xB0, count + " samples of unit " + (high >> 6) + " are no scan");
    }
    if ((high & 0x20) != 0) {
      return malformed(0xB0, "it is a part of a scan, which was not requested");
    }
    int[] samples = new int[count];
    for (int i = 0; i < count; i++) {
      samples[i] = LmsFramer.u16(bytes, at + 3 + 2 * i);
    }
    int index = counters == 0 ? -1 : bytes[at + 3 + 2 * count] & 0xFF;
    return new LmsScan(LmsUnit.values()[high >> 6], samples, index, status);
  }

  /** Offsets are those from the reply's command. */
  private static LmsMessage status(byte[] bytes, int at, int end, StatusByte status) {
    if (end - at < STATUS_BYTES) {
      return malformed(0xB1, "it has " + (end - at) + " of " + STATUS_BYTES + " bytes");
    }
    List<Integer> pollution = new ArrayList<>();
    for (int i = 0; i < POLLUTION_CHANNELS; i++) {
      int now = LmsFramer.u16(bytes, at + 19 + 2 * i);
      int clean = LmsFramer.u16(bytes, at + 43 + 2 * i);
      pollution.add(clean == 0 ? 100 : 100 * now / clean);
    }
    int unit = bytes[at + 122] & 0xFF;
    return new LmsStatus(
        text(bytes, at + 1, 7),
        bytes[at + 8] & 0xFF,
        bytes[at + 9] != 0,
        pollution,
        LmsFramer.u16(bytes, at + 67),
        LmsFramer.u16(bytes, at + 83),
        bytes[at + 102] & 0xFF,
        LmsVariant.of(LmsFramer.u16(bytes, at + 107), LmsFramer.u16(bytes, at + 109)),
        unit < LmsUnit.values().length ? Optional.of(LmsUnit.values()[unit]) : Optional.empty(),
        LmsBaud.ofRegister(LmsFramer.u16(bytes, at + 116)),
        bytes[at + 123] != 0,
        status);
  }

  private static LmsMessage errors(byte[] bytes, int at, int end, StatusByte status) {
    List<LmsError> errors = new ArrayList<>();
    for (int i = at; i + 1 < end; i += 2) {
      errors.add(new LmsError(bytes[i] & 0xFF, bytes[i + 1] & 0xFF));
    }
    return (end - at) % 2 == 0
        ? new LmsMessage.ErrorsReply(errors, status)
        : malformed(0xB2, (end - at) + " bytes are no pairs of type and number");
  }

  private static LmsMessage variant(byte[] bytes, int at, int end, StatusByte status) {
    if (end - at < 6) {
      return malformed(0xBB, "it has " + (end - at) + " of 6 bytes");
    }
    int degrees = LmsFramer.u16(bytes, at + 2);
    int hundredths = LmsFramer.u16(bytes, at + 4);
    return LmsVariant.of(degrees, hundredths)
        .<LmsMessage>map(
            reported -> new LmsMessage.VariantReply(bytes[at + 1] == 1, reported, status))
        .orElseGet(
            () -> malformed(0xBB, degrees + "° by 0.01 × " + hundredths + "° are no variant"));
  }

  private static LmsMessage configuration(byte[] bytes, int at, int end, StatusByte status) {
    boolean isAnswer = (bytes[at] & 0xFF) == 0xF7;
    int from = at + (isAnswer ? 2 : 1);
    int length = end - from;
    if (length < LmsConfiguration.SHORTEST || length > LmsConfiguration.LONGEST) {
      return malformed(bytes[at] & 0xFF, length + " bytes are no configuration");
    }
    LmsConfiguration reported = new LmsConfiguration(Arrays.copyOfRange(bytes, from, end));
    return isAnswer
        ? new LmsMessage.ConfigurationChangeReply(bytes[at + 1] == 1, reported, status)
        : new LmsMessage.ConfigurationReply(reported, status);
  }

  private static LmsMessage malformed(int command, String reason) {
    return new LmsMessage.Malformed(String.format(Locale.ROOT, "%02X", command), reason);
  }

  /** Printable text; bytes after a zero are ignored. */
  private static String text(byte[] bytes, int from, int length) {
    String all = new String(bytes, from, length, StandardCharsets.US_ASCII);
    int zero = all.indexOf(0);
    return (zero < 0 ? all : all.substring(0, zero)).replaceAll("[^ -~]", "?").strip();
  }
}
