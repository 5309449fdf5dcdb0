package org.dfra.drivers.laser.lms;

import java.util.List;
import java.util.Locale;

/** A message from the laser, decoded from one intact frame. */
public sealed interface LmsMessage {

  /** Its name, for operators and for threads that wait for it: a reply's command in hex, or NAK. */
  String name();

  /** A telegram, which ends with the laser's status. */
  sealed interface Telegram extends LmsMessage permits LmsScan, LmsStatus, Reply {

    /** The laser's status. */
    StatusByte status();
  }

  /** A telegram that answers a command, or reports that the laser has started. */
  sealed interface Reply extends Telegram {}

  /** {@code 15}: the laser could not read the last telegram. */
  record Nak() implements LmsMessage {

    @Override
    public String name() {
      return "NAK";
    }
  }

  /** {@code 90}: it is ready, at 9600 baud, after power-on or reset; {@code BA}: its type. */
  record TypeReply(boolean isPowerOn, String type, StatusByte status) implements Reply {

    @Override
    public String name() {
      return isPowerOn ? "90" : "BA";
    }
  }

  /** {@code 91}: it resets now. */
  record ResetReply(StatusByte status) implements Reply {

    @Override
    public String name() {
      return "91";
    }
  }

  /** {@code 92}: the command is unknown, or cannot be executed now. */
  record RefusedReply(StatusByte status) implements Reply {

    @Override
    public String name() {
      return "92";
    }
  }

  /**
   * {@code A0}: result of a change of its operating mode.
   *
   * @param result 0 done, 1 the password is wrong, 2 the laser has a fault
   */
  record ModeReply(int result, StatusByte status) implements Reply {

    @Override
    public String name() {
      return "A0";
    }

    /** Whether it is in that mode now. */
    public boolean isDone() {
      return result == 0;
    }
  }

  /**
   * {@code BB}: result of a change of variant.
   *
   * @param isDone whether it was changed
   * @param variant the current one
   */
  record VariantReply(boolean isDone, LmsVariant variant, StatusByte status) implements Reply {

    @Override
    public String name() {
      return "BB";
    }
  }

  /** {@code F4}: its configuration. */
  record ConfigurationReply(LmsConfiguration configuration, StatusByte status) implements Reply {

    @Override
    public String name() {
      return "F4";
    }
  }

  /**
   * {@code F7}: result of a change of its configuration.
   *
   * @param isDone whether it was changed
   * @param configuration the current one
   */
  record ConfigurationChangeReply(boolean isDone, LmsConfiguration configuration, StatusByte status)
      implements Reply {

    @Override
    public String name() {
      return "F7";
    }
  }

  /** {@code B2}: its stored errors. */
  record ErrorsReply(List<LmsError> errors, StatusByte status) implements Reply {

    public ErrorsReply {
      errors = List.copyOf(errors);
    }

    @Override
    public String name() {
      return "B2";
    }
  }

  /**
   * An error that the laser has stored.
   *
   * @param type as the lower bits of a {@link StatusByte}; bit 7 if it is no longer present
   * @param number error number of the telegram listing
   */
  record LmsError(int type, int number) {

    /** Whether it is still present. */
    public boolean isPresent() {
      return (type & 0x80) == 0;
    }

    /** {@code error 21 (WARNING)}. */
    public String inWords() {
      return "error "
          + number
          + " ("
          + new StatusByte(type & 7).severity()
          + (isPresent() ? ")" : ", over)");
    }
  }

  /**
   * An intact telegram of another kind.
   *
   * @param command its first byte, 80 to FF hex
   */
  record Other(int command, StatusByte status) implements Reply {

    @Override
    public String name() {
      return String.format(Locale.ROOT, "%02X", command);
    }
  }

  /**
   * An intact telegram with invalid content.
   *
   * @param name the name of the valid message
   * @param reason which value, what it is, and which values are valid
   */
  record Malformed(String name, String reason) implements LmsMessage {}
}
