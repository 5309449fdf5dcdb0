package org.dfra.drivers.laser.lms;

import java.time.Duration;

/**
 * Something that the laser is asked or told, of which one at a time is under way.
 *
 * @param kind what
 * @param telegram the bytes to send
 */
record LmsRequest(Kind kind, byte[] telegram) {

  /** What it is about, what answers it, and how long that may take. */
  enum Kind {
    /** To send scans only when asked; ends a stream and installation mode. */
    STOP("A0", 1500, "to wait for orders"),
    /** How it is. */
    STATUS("B1", 1500, "how it is"),
    /** To use another speed. */
    BAUD("A0", 1500, "to change its baud rate"),
    /** What it is. */
    TYPE("BA", 1500, "what it is"),
    /** How it is configured. */
    CONFIGURATION("F4", 1500, "for its configuration"),
    /** To let its configuration be changed. */
    INSTALLATION("A0", 3000, "to enter installation mode"),
    /** To change its configuration; a flash memory is slow. */
    CONFIGURE("F7", 15_000, "to change its configuration"),
    /** To place its beams otherwise. */
    VARIANT("BB", 3000, "to change its field of view and resolution"),
    /** Which errors it remembers. */
    ERRORS("B2", 1500, "for its errors"),
    /** To send one scan after the other. */
    STREAM("A0", 1500, "to stream scans"),
    /** To send a scan. */
    SCAN("B0", 2000, "for a scan"),
    /** To begin anew. */
    RESET("91", 3000, "to reset itself");

    private final String answer;
    private final Duration patience;
    private final String words;

    Kind(String answer, int millis, String words) {
      this.answer = answer;
      this.patience = Duration.ofMillis(millis);
      this.words = words;
    }

    /** Name of the message that answers. */
    String answer() {
      return answer;
    }

    /** How long the answer may take. */
    Duration timeout() {
      return patience;
    }

    /** As the rest of: {@code the laser was asked …}. */
    String words() {
      return words;
    }
  }

  static final LmsRequest STOP = new LmsRequest(Kind.STOP, LmsCommands.stop());
  static final LmsRequest STATUS = new LmsRequest(Kind.STATUS, LmsCommands.status());
  static final LmsRequest TYPE = new LmsRequest(Kind.TYPE, LmsCommands.type());
  static final LmsRequest ERRORS = new LmsRequest(Kind.ERRORS, LmsCommands.errors());
  static final LmsRequest STREAM = new LmsRequest(Kind.STREAM, LmsCommands.stream());
  static final LmsRequest SCAN = new LmsRequest(Kind.SCAN, LmsCommands.scan());
  static final LmsRequest RESET = new LmsRequest(Kind.RESET, LmsCommands.reset());
  static final LmsRequest CONFIGURATION =
      new LmsRequest(Kind.CONFIGURATION, LmsCommands.configuration());
  static final LmsRequest INSTALLATION =
      new LmsRequest(Kind.INSTALLATION, LmsCommands.installation());

  static LmsRequest baud(LmsBaud baud) {
    return new LmsRequest(Kind.BAUD, LmsCommands.baud(baud));
  }

  static LmsRequest variant(LmsVariant variant) {
    return new LmsRequest(Kind.VARIANT, LmsCommands.variant(variant));
  }

  static LmsRequest configure(LmsConfiguration configuration) {
    return new LmsRequest(Kind.CONFIGURE, LmsCommands.configure(configuration));
  }
}
